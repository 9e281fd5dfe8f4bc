"""docs/reference/limits.md: every limit of the API, from limits.schema.json."""
from .base import MADE, UP, api, number, table

INTRO = f"""# Limits

What one server allows. A request beyond a limit is refused with a sentence that names it, and never served in part. Limits of people, links and
addresses, and what happens to slow clients, are in the server's documents: [budgets]({UP}server/live/compute/README.md#what-each-person-may-ask-for),
[connections]({UP}server/net/README.md#connections).

"""


def text():
    rows = {True: [], False: []}
    for name, data in api().limits:
        told = name in api().told
        rows[told].append([f"`{name}`", f"{number(data['const'])} {data.get('x-unit', '')}".strip(), data["description"]])
    return (MADE.format(source="protocol/api/limits.schema.json") + INTRO
            + "## Told by the server\n\n`server.info` returns these, so that a program need not know them.\n\n"
            + table(["name", "limit", "of what"], rows[True])
            + "\n## Of parameters\n\nThe API refuses more with `invalidParameters`.\n\n"
            + table(["name", "limit", "of what"], rows[False]))
