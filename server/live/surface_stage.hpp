// The stage that a live surface is in, and the events that lead from one to another. An event that is not in
// the table leaves the stage as it is.
//
// | event                    | in                           | leads to                                     |
// | ------------------------ | ---------------------------- | -------------------------------------------- |
// | rebuild                  | any                          | Begun, or Resting until a client asks for it |
// | refuse                   | any                          | Refused, or Withheld until a client asks     |
// | begin_now                | Resting, Interrupted         | Begun                                        |
// | begin_now                | Failed, for want of memory   | Begun                                        |
// | begin_now                | Withheld                     | Refused: data, or an edit, will come         |
// | resume                   | Interrupted                  | Begun                                        |
// | fall_back                | Begun, Coarse, Refined, Full | Resting                                      |
// | put_to_rest, if not busy | Begun, Coarse, Refined, Full | Resting                                      |
// | put_to_rest, if busy     | Begun, Coarse, Refined, Full | Interrupted                                  |
// | a pass ends, well or not | Begun, Coarse                | Coarse, Refined: the pass that ended         |
// | a pass of full quality   | Begun, Coarse, Refined, Full | Full; there it follows the clock             |
// | the last pass fails      | Begun, Coarse, Refined, Full | Failed                                       |
// | stop, if busy            | any but Failed               | Refused                                      |
// | retire                   | any                          | Refused                                      |
//
// In Begun to Full it is computed, unless every client that showed it has stopped doing so.
#pragma once

#include "server/live/surface_job.hpp"

namespace wakesurf::server {

/// Stages in order of what is there.
enum class SurfaceStage {
    Withheld,    ///< there is nothing to build, and no client has asked for it
    Refused,     ///< there is nothing to build: data are missing, or it was stopped
    Failed,      ///< computing it failed
    Resting,     ///< it is built when a client asks for it
    Interrupted, ///< as Resting; it was being computed when the last client left
    Begun,       ///< nothing is there yet
    Coarse,      ///< the coarse pass has ended
    Refined,     ///< the refined pass has ended
    Full         ///< a state of full quality is there
};

/// Returns true where nothing is built, or being built, until a client asks for it.
constexpr bool rests(SurfaceStage stage) {
    return stage == SurfaceStage::Withheld || stage == SurfaceStage::Resting ||
           stage == SurfaceStage::Interrupted;
}

/// Returns the stage that the end of a pass leads to.
constexpr SurfaceStage stage_after(Phase phase) {
    switch (phase) {
    case Phase::Coarse:
        return SurfaceStage::Coarse;
    case Phase::Refined:
        return SurfaceStage::Refined;
    default:
        return SurfaceStage::Full;
    }
}

} // namespace wakesurf::server
