"""docs/reference/metrics.md: what /metrics of a running server says of itself."""
import re
import subprocess
import tempfile
import time
import urllib.request

from .base import MADE, binary, said, table

INTRO = """# Metrics

`GET /metrics` answers in the text format of Prometheus. It needs the server's token:

```sh run serve
wakesurf serve flow:tornado --token-file token
```

```sh run
curl -sS -H "Authorization: Bearer $(cat token)" http://127.0.0.1:8080/metrics -o metrics.txt
grep wakesurf_build_info metrics.txt
```

For monitors that only ask whether the server is well, `GET /healthz` answers 200 without a token, and `ok`. Where datasets could not be opened or
imported it is 200 still, since the others can be used, and says how many: `ok, but of 3 datasets 1 has failed`. Which, and why, the log says
(`event=dataset_failed`), and `dataset.list`. For an alarm: `wakesurf_datasets{state="failed"} > 0`.

"""


MOST_SCRAPES = 300


def scraped():
    with tempfile.TemporaryDirectory() as folder:
        said("generate", "tornado", folder + "/store", "--grid", "8,8,8", "--times", "0:1:4",
             "--layout", "bricks")  # for the cache of its time-steps, and its bricks
        command = [binary(), "serve", folder + "/store", "--listen", "127.0.0.1:0", "--store", folder + "/imported",
                   "--state", folder + "/state", "--bricks", "false"]  # counted from the first try on, also where no rank ever comes
        with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True) as server:
            try:
                address, token = server.stdout.readline().split()[1].split("/#token=")
                session = '{"jsonrpc":"2.0","id":1,"method":"no.such"}'.encode()
                headers = {"Authorization": "Bearer " + token, "Content-Type": "application/json"}
                urllib.request.urlopen(urllib.request.Request(address + "/rpc", session, headers), timeout=20).read()
                scrape = urllib.request.Request(address + "/metrics", headers=headers)
                for _ in range(MOST_SCRAPES):
                    with urllib.request.urlopen(scrape, timeout=20) as answer:
                        told = answer.read().decode()
                    if "wakesurf_cache_bytes" in told:
                        return told
                    time.sleep(0.1)  # the store is still being imported
                raise RuntimeError("the server tells of no cache: has the import failed?")
            finally:
                server.terminate()
                server.wait(timeout=20)


def text():
    told = scraped()
    kinds = dict(re.findall(r"^# TYPE (\S+) (\S+)$", told, re.M))
    rows = []
    for name, words in sorted(re.findall(r"^# HELP (\S+) (.*)$", told, re.M)):
        labels = sorted({label for line in re.findall(rf"^{name}(?:_bucket|_count|_sum)?\{{(.*?)\}}", told, re.M)
                         for label in re.findall(r'(\w+)="', line)} - {"le"})
        rows.append([f"`{name}`", kinds[name], ", ".join(f"`{each}`" for each in labels), words])
    return (MADE.format(source="/metrics of a running server") + INTRO + table(["name", "type", "labels", "what"], rows)
            + "\nA family is there from its first value on: `wakesurf_cache_*` with the first dataset whose time-steps are stored,\n"
              "`wakesurf_brick*` with the first that an MPI job is to hold (`serve --bricks`).\n"
              "`wakesurf_brick_ranks == 0` for minutes says that there is no job: the log says why (`event=bricks_job_ended`).\n")
