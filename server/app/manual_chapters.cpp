#include "server/app/manual_chapters.hpp"

namespace wakesurf::server {

std::string_view manual_chapters() {
    return R"roff(.SH ENVIRONMENT
.TP
\fBWAKESURF_DATASET\fR, \fBWAKESURF_LISTEN\fR, \fBWAKESURF_STORE\fR, \fBWAKESURF_STATE\fR, \fBWAKESURF_TOKEN_FILE\fR
Defaults of what \fBwakesurf serve\fR takes by the option of that name.
.TP
\fBWAKESURF_URL\fR
Address of the server that \fBwakesurf sessions\fR, \fBwakesurf mcp\fR and scripts talk to.
.TP
\fBWAKESURF_HTTP_TOKEN\fR
Sent as a bearer\(aqs token to the web servers that stores are read from.
.TP
\fBWAKESURF_HTTP_S3_REGION\fR
Requests to them are signed for S3 in that region, with \fBAWS_ACCESS_KEY_ID\fR, \fBAWS_SECRET_ACCESS_KEY\fR and, where it is set,
\fBAWS_SESSION_TOKEN\fR.
.TP
\fBSSL_CERT_FILE\fR
Whom of them to trust, beside those whom the system trusts.
.TP
\fBBROWSER\fR
What opens the page, several with colons between them, \fI%s\fR for its address; else \fBxdg\-open\fR(1).
.TP
\fBWAKESURF_PYTHON\fR
The Python of \fBwakesurf mcp\fR, with numpy; else the system's.
.SH FILES
.TP
\fI~/.cache/wakesurf\fR
Imported data, unless \fB\-\-store\fR says otherwise. It can be deleted: it is made again from the simulation's files.
.TP
\fI../share/wakesurf/web\fR, \fI../share/wakesurf/data\fR
The page and the bundled simulation, as seen from the program.
.TP
\fI../share/wakesurf/python\fR
The client for scripts.
.SH EXIT STATUS
0 done, 1 failed, 2 wrong usage. What was wrong is on standard error, with what to do about it.
.SH EXAMPLES
.TP
The bundled simulation, in the browser
\fBwakesurf\fR
.TP
Own data, in the browser; by ssh it says what to type on your own machine
\fBwakesurf case.foam\fR
.TP
Own data, with sessions that outlive the server
\fBwakesurf serve case.foam \-\-state ~/.local/state/wakesurf\fR
.TP
From a laptop, where the server runs on another machine
\fBssh \-L 8080:localhost:8080 that.machine\fR
.TP
One surface to a file, without a server
\fBwakesurf surface case.foam \-\-kind streak \-o surface.vtp\fR
.SH SEE ALSO
\fBwakesurf\-import\fR(1), \fBparaview\fR(1)
)roff";
}

} // namespace wakesurf::server
