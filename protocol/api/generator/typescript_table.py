"""TypeScript: all methods and notifications of the server, with the checks of what it sends; limits and codes of errors."""
from .schema import NOUNS, camel
from .typescript import MADE, TypeScript, comment, quoted

ANY_SCHEMA = "*.schema.json"


class Tables(TypeScript):
    """Writes all files."""

    def params_type(self, method):
        return self.use(f"./{method.noun}.ts", camel(method.name) + "Params") if method.params.fields else "Record<string, never>"

    def result_type(self, method):
        if self.is_named(method.result):
            return self.type(method.result)
        return self.use(f"./{method.noun}.ts", camel(method.name) + "Result") if method.result.fields else "object"

    def result_check(self, method):
        if self.is_named(method.result) or not method.result.fields:
            return self.check(method.result)
        return self.members(self.result_type(method), method.result.fields)

    def methods(self):
        self.used, entries = {}, []
        for method in self.api.methods:
            types = f"params: {self.params_type(method)}; result: {self.result_type(method)}"
            entries += [*comment(method.words, 4), f"    {quoted(method.name)}: {{ {types} }};"]
        body = ["/** Every method of the server. */", "export interface Methods {", *entries, "}", ""]
        return self.with_imports("methods", ANY_SCHEMA, body)

    def results(self):
        self.used = {}
        entries = [f"    {quoted(method.name)}: {self.result_check(method)}," for method in self.api.methods]
        check, methods = self.use("../checks.ts", "Check"), self.use("./methods.ts", "Methods")
        body = ["/** What a method must answer. */",
                f"export const resultChecks: {{ [Name in keyof {methods}]: {check}<{methods}[Name]['result']> }} = {{", *entries, "};", ""]
        return self.with_imports("results", ANY_SCHEMA, body)

    def notifications(self):
        self.used = {}
        shapes, types, checks = [], [], []
        for name, _, words, params in self.api.notifications:
            if self.is_named(params):
                shape, check = self.type(params), self.check(params)
            else:
                shape = camel(name)
                shapes += self.interface(shape, words, params.fields)
                check = self.members(shape, params.fields)
            types += [*comment(words, 4), f"    {quoted(name)}: {shape};"]
            checks.append(f"    {quoted(name)}: {check},")
        check = self.use("../checks.ts", "Check")
        body = [*shapes, "/** Every notification of the server, by its method. */", "export interface Notifications {", *types, "}", "",
                "/** What a notification must say. */",
                f"export const notificationChecks: {{ [Name in keyof Notifications]: {check}<Notifications[Name]> }} = {{", *checks, "};", ""]
        return self.with_imports("notifications", ANY_SCHEMA, body)

    def limits(self):
        self.used = {}
        told, others = [[line for name, data in self.api.limits if (name in self.api.told) == wanted for line in
                         [*comment(data["description"] + (f" ({data['x-unit']})" if "x-unit" in data else ""), 4),
                          f"    {name}: {data['const']:_},"]] for wanted in (True, False)]
        lines = ["/** What one server of this version grants, as far as server.info returns it. */", "export const toldLimits = {",
                 *told, "} as const;", "",
                 "/** What one server of this version grants. */", "export const limits = {", "    ...toldLimits,", *others, "} as const;", "",
                 *comment(self.api.shape("Limits").words, 0), "export type Limits = { -readonly [Name in keyof typeof toldLimits]: number };", "",
                 f"export const limitsCheck = {self.primitive('wholeMembers')}(toldLimits);", ""]
        return self.with_imports("limits", "limits.schema.json", lines)

    def error_codes(self):
        codes = ", ".join(f"{kind}: {data['code']}" for kind, data in self.api.errors.items())
        return "\n".join([MADE.format("errors.schema.json"), "", "/** Codes of errors, by kind. */",
                          f"export const errorCodes = {{ {codes} }} as const;", ""])

    def files(self):
        out = {**{f"{noun}.ts": self.noun(noun) for noun in (*NOUNS, "shared")}, "limits.ts": self.limits(), "errors.ts": self.error_codes()}
        self.by_noun = True
        return {**out, "methods.ts": self.methods(), "results.ts": self.results(), "notifications.ts": self.notifications()}
