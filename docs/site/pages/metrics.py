"""A table of the metrics that a running server describes."""
import re
import subprocess
import tempfile
import time
import urllib.request

from .base import binary, said, table

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
                        answered = answer.read().decode()
                    if "wakesurf_cache_bytes" in answered:
                        return answered
                    time.sleep(0.1)  # the store is still being imported
                raise RuntimeError("the server has no metrics of a cache: has the import failed?")
            finally:
                server.terminate()
                server.wait(timeout=20)


def text():
    exposition = scraped()
    kinds = dict(re.findall(r"^# TYPE (\S+) (\S+)$", exposition, re.M))
    rows = []
    for name, words in sorted(re.findall(r"^# HELP (\S+) (.*)$", exposition, re.M)):
        labels = sorted({label for line in re.findall(rf"^{name}(?:_bucket|_count|_sum)?\{{(.*?)\}}", exposition, re.M)
                         for label in re.findall(r'(\w+)="', line)} - {"le"})
        rows.append([f"`{name}`", kinds[name], ", ".join(f"`{each}`" for each in labels), words])
    return table(["name", "type", "labels", "what"], rows)
