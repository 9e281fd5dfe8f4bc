"""A client of the Model Context Protocol for tests: it drives the real program over its standard input and output."""
import json
import os
import subprocess
import sys

from real_server import BINARY, ROOT


class Agent:
    """`python -m wakesurf.mcp ARGUMENTS`, or `command`; ends with its block."""

    def __init__(self, *arguments, folder, command=None, environment=()):
        variables = {name: value for name, value in os.environ.items() if name not in ("WAKESURF_URL", "WAKESURF_TOKEN")}
        variables.update({"PYTHONPATH": os.path.join(ROOT, "python"), "WAKESURF": BINARY,
                          "WAKESURF_STORE": os.path.join(folder, "store"), **dict(environment)})
        self.process = subprocess.Popen([*(command or (sys.executable, "-m", "wakesurf.mcp")), *arguments, "--folder", folder],
                                        stdin=subprocess.PIPE, stdout=subprocess.PIPE, cwd=folder, env=variables)
        self.notifications, self._last = [], 0

    def __enter__(self):
        return self

    def __exit__(self, *_):
        if not self.process.stdin.closed:
            self.process.stdin.close()
        self.process.wait(timeout=60)
        self.process.stdout.close()

    def write(self, text):
        """A line as it is."""
        self.process.stdin.write(text if isinstance(text, bytes) else text.encode())
        self.process.stdin.write(b"\n")
        self.process.stdin.flush()

    def start(self, method, **parameters):
        """Sends a request; its id."""
        self._last += 1
        self.write(json.dumps({"jsonrpc": "2.0", "id": self._last, "method": method, "params": parameters}))
        return self._last

    def notify(self, method, **parameters):
        self.write(json.dumps({"jsonrpc": "2.0", "method": method, "params": parameters}))

    def read(self):
        """The next message that is no notification; those are collected in `notifications`."""
        while True:
            line = self.process.stdout.readline()
            if not line:
                raise EOFError("the program has ended")
            message = json.loads(line)
            if isinstance(message, list) or "method" not in message:
                return message
            self.notifications.append(message)

    def ask(self, method, **parameters):
        """The whole answer to a request."""
        number = self.start(method, **parameters)
        answer = self.read()
        assert answer["id"] == number, answer
        return answer

    def begin(self, version="2025-06-18"):
        """As every client begins."""
        answer = self.ask("initialize", protocolVersion=version, capabilities={}, clientInfo={"name": "test", "version": "1"})
        self.notify("notifications/initialized")
        return answer["result"]

    def call(self, tool, **arguments):
        """What a tool answers."""
        return self.ask("tools/call", name=tool, arguments=arguments)["result"]

    def numbers(self, tool, **arguments):
        """The numbers that a tool answers; fails where it failed."""
        result = self.call(tool, **arguments)
        assert not result["isError"], result["content"][0]["text"]
        return result["structuredContent"]

    def refusal(self, tool, **arguments):
        """The words in which a tool fails."""
        result = self.call(tool, **arguments)
        assert result["isError"], result
        return result["content"][0]["text"]
