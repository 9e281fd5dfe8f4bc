"""All records.

Made by protocol/api/generate from protocol/api/*.schema.json: do not edit.
"""
from .shared import Lattice, Problem
from .server import (Quantiles, CacheStanding, MemoryStanding, Stages, RpcDiscoverResult, ServerInfoResult,
                     ServerStatsResult)
from .dataset import (Steps, DatasetEntry, Field, Dataset, SuggestedSurface, SuggestedRake, CacheStatus,
                      DatasetListResult, DatasetSuggestResult, ProbeSampleResult)
from .family import FamilyStep, Family
from .session import (AsideRecord, KeptAside, Units, Snapshot, SessionName, SessionMade, TimesOfDataset, NamedDataset,
                      FileRecords, SessionFile, Visitor, SessionEntry, Patch, Joined, SessionForkResult,
                      SessionListResult, SessionStateResult, SessionDeleteResult, SessionExportResult,
                      SessionImportResult)
from .share import (ShareMaker, Share, SessionShareResult, SessionSharesResult, SessionUnshareResult,
                    SessionSetRoleResult)
from .presence import Camera, DraggedRake, Presence, Participant
from .rake import RakeRecord, SurfaceEpoch, RakeSetResult, RakeListResult
from .surface import SurfaceRecord, SurfaceSetResult, SurfaceStopResult, SurfaceListResult
from .subscription import (PassSeconds, Terminations, BuildSeconds, Emptiness, Statistics, ValueRange,
                           SurfaceSubscribeResult)
from .bookmark import BookmarkRecord, BookmarkSetResult, BookmarkListResult
from .annotation import AnnotationRecord, AnnotationSetResult, AnnotationListResult
from .history import Change, Skip, HistoryDepth, HistoryUndoResult, HistoryRedoResult
from .time import ClockRecord, ClockAnswer

__all__ = ["Lattice", "Problem", "Quantiles", "CacheStanding", "MemoryStanding", "Stages", "Steps", "DatasetEntry",
           "Field", "Dataset", "SuggestedSurface", "SuggestedRake", "CacheStatus", "FamilyStep", "Family",
           "AsideRecord", "KeptAside", "Units", "Snapshot", "SessionName", "SessionMade", "TimesOfDataset",
           "NamedDataset", "FileRecords", "SessionFile", "Visitor", "SessionEntry", "Patch", "Joined", "ShareMaker",
           "Share", "Camera", "DraggedRake", "Presence", "Participant", "RakeRecord", "SurfaceEpoch", "SurfaceRecord",
           "SurfaceSetResult", "PassSeconds", "Terminations", "BuildSeconds", "Emptiness", "Statistics", "ValueRange",
           "BookmarkRecord", "AnnotationRecord", "Change", "Skip", "HistoryDepth", "ClockRecord", "ClockAnswer",
           "RpcDiscoverResult", "ServerInfoResult", "ServerStatsResult", "DatasetListResult", "DatasetSuggestResult",
           "ProbeSampleResult", "SessionForkResult", "SessionListResult", "SessionStateResult", "SessionDeleteResult",
           "SessionExportResult", "SessionImportResult", "SessionShareResult", "SessionSharesResult",
           "SessionUnshareResult", "SessionSetRoleResult", "RakeSetResult", "RakeListResult", "SurfaceStopResult",
           "SurfaceListResult", "SurfaceSubscribeResult", "BookmarkSetResult", "BookmarkListResult",
           "AnnotationSetResult", "AnnotationListResult", "HistoryUndoResult", "HistoryRedoResult"]
