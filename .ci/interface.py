#!/usr/bin/env python3
"""The public interface of the crate, an item a line, from the JSON that rustdoc writes.

    python3 .ci/interface.py target/interface/doc/hemidisc.json

`bash .ci/run interface` makes the JSON and compares the list with docs/public-api.txt.
Paths begin at the crate's root, and names of `core` are without their modules.
Left out are hidden items, implementations of traits that a user cannot name,
and those that the compiler makes by itself (`Send`, `Sync`, `impl<T> Any for T`).
"""

import collections
import json
import sys

# Rustdoc's JSON is not stable; rustc 1.95 and 1.97 write this format.
FORMAT = 57
# What is counted in the first line.
KINDS = ["struct", "enum", "trait", "fn", "type", "const", "macro"]


class Listing:
    def __init__(self, crate):
        self.index = crate["index"]
        self.names = crate["paths"]
        self.root = str(crate["root"])
        self.public = {}  # The path of each item that a user can name.
        # (path, whether it implements, line): sorted, a type's lines are together.
        self.lines = []
        self.counts = collections.Counter()

    def item(self, key):
        """The item of an id, and its kind with what is inside; None if it is hidden."""
        item = self.index.get(str(key))
        if item is None:
            return None, None, None
        ((kind, inner),) = item["inner"].items()
        return item, kind, inner

    # What a user can name.

    def walk(self, module, path, uses, found):
        """Adds (how many re-exports lead to it, depth, path) under each id of the module."""
        for key in self.item(module)[2]["items"]:
            item, kind, inner = self.item(key)
            if item is None or item["visibility"] != "public":
                continue
            if kind != "use":
                self.reach(key, path + [item["name"]], uses, found)
            elif str(inner["id"]) in self.index:
                if not inner["is_glob"]:
                    self.reach(inner["id"], path + [inner["name"]], uses + 1, found)
                else:
                    self.walk(inner["id"], path, uses + 1, found)

    def reach(self, key, path, uses, found):
        found[str(key)].append((uses, len(path), "::".join(path)))
        if self.item(key)[1] == "module":
            self.walk(key, path, uses, found)

    # Types as they are written.

    def path(self, path):
        if path["id"] is not None and str(path["id"]) in self.public:
            name = self.public[str(path["id"])]
        else:
            known = self.names.get(str(path["id"]))
            parts = known["path"] if known else path["path"].split("::")
            name = parts[-1] if parts[0] in ("core", "alloc", "std") else "::".join(parts)
        return name + self.arguments(path.get("args"))

    def arguments(self, arguments):
        if not arguments:
            return ""
        ((kind, inner),) = arguments.items()
        if kind == "parenthesized":
            return "(" + self.all(inner["inputs"]) + ")" + self.returned(inner["output"])
        if kind != "angle_bracketed":
            raise ValueError(f"arguments of a new kind: {kind}")
        texts = [self.argument(argument) for argument in inner["args"]]
        for constraint in inner["constraints"]:
            ((how, what),) = constraint["binding"].items()
            name = constraint["name"] + self.arguments(constraint["args"])
            if how == "equality":
                texts.append(f"{name} = {self.term(what)}")
            else:
                texts.append(f"{name}: {self.bounds(what)}")
        return "<" + ", ".join(texts) + ">" if texts else ""

    def argument(self, argument):
        if argument == "infer":
            return "_"
        ((kind, inner),) = argument.items()
        if kind == "lifetime":
            return inner
        return self.type(inner) if kind == "type" else inner["expr"]

    def term(self, term):
        return self.type(term["type"]) if "type" in term else term["constant"]["expr"]

    def all(self, types):
        return ", ".join(self.type(each) for each in types)

    def returned(self, output):
        return f" -> {self.type(output)}" if output else ""

    def type(self, given):
        if given == "infer":
            return "_"
        ((kind, inner),) = given.items()
        if kind == "resolved_path":
            return self.path(inner)
        if kind in ("generic", "primitive"):
            return inner
        if kind == "tuple":
            return "(" + self.all(inner) + ("," if len(inner) == 1 else "") + ")"
        if kind == "slice":
            return f"[{self.type(inner)}]"
        if kind == "array":
            return f"[{self.type(inner['type'])}; {inner['len']}]"
        if kind == "impl_trait":
            return f"impl {self.bounds(inner)}"
        if kind == "borrowed_ref":
            lifetime = inner["lifetime"] + " " if inner["lifetime"] else ""
            mutable = "mut " if inner["is_mutable"] else ""
            return f"&{lifetime}{mutable}{self.type(inner['type'])}"
        if kind == "qualified_path":
            of = self.type(inner["self_type"])
            name = inner["name"] + self.arguments(inner["args"])
            trait = inner["trait"] and inner["trait"]["path"] and self.path(inner["trait"])
            return f"<{of} as {trait}>::{name}" if trait else f"{of}::{name}"
        if kind == "function_pointer":
            inputs = self.all(each for _, each in inner["sig"]["inputs"])
            return f"fn({inputs}){self.returned(inner['sig']['output'])}"
        raise ValueError(f"a type of a new kind: {kind}")

    # Generics.

    def bounds(self, bounds):
        return " + ".join(self.bound(bound) for bound in bounds)

    def bound(self, bound):
        ((kind, inner),) = bound.items()
        if kind == "outlives":
            return inner
        if kind == "use":
            return "use<" + ", ".join(next(iter(each.values())) for each in inner) + ">"
        binder = self.parameters(inner["generic_params"])
        maybe = "?" if inner["modifier"] == "maybe" else ""
        return f"{'for' + binder + ' ' if binder else ''}{maybe}{self.path(inner['trait'])}"

    def parameters(self, parameters):
        texts = []
        for parameter in parameters:
            ((kind, inner),) = parameter["kind"].items()
            text = parameter["name"]
            if kind == "lifetime" and inner["outlives"]:
                text += ": " + " + ".join(inner["outlives"])
            elif kind == "type":
                if inner["is_synthetic"]:
                    continue
                text += ": " + self.bounds(inner["bounds"]) if inner["bounds"] else ""
                text += " = " + self.type(inner["default"]) if inner["default"] else ""
            elif kind == "const":
                text = f"const {text}: {self.type(inner['type'])}"
                text += f" = {inner['default']}" if inner["default"] else ""
            texts.append(text)
        return "<" + ", ".join(texts) + ">" if texts else ""

    def where(self, *several):
        texts = []
        for generics in several:
            for predicate in generics["where_predicates"]:
                ((kind, inner),) = predicate.items()
                if kind == "bound_predicate":
                    binder = self.parameters(inner["generic_params"])
                    before = f"for{binder} " if binder else ""
                    bounds = self.bounds(inner["bounds"])
                    texts.append(f"{before}{self.type(inner['type'])}: {bounds}")
                elif kind == "lifetime_predicate":
                    texts.append(f"{inner['lifetime']}: " + " + ".join(inner["outlives"]))
                else:
                    texts.append(f"{self.type(inner['lhs'])} = {self.term(inner['rhs'])}")
        return " where " + ", ".join(texts) if texts else ""

    # Items.

    def function(self, name, inner, outside=None):
        sig, header = inner["sig"], inner["header"]
        inputs = []
        for argument, of in sig["inputs"]:
            text = self.type(of)
            if argument == "self":
                short = {"Self": "self", "&Self": "&self", "&mut Self": "&mut self"}
                inputs.append(short.get(text, f"self: {text}"))
            else:
                inputs.append(f"{argument}: {text}")
        const = "const " if header["is_const"] else ""
        unsafe = "unsafe " if header["is_unsafe"] else ""
        generics = [inner["generics"]] + ([outside] if outside else [])
        return (
            f"{const}{unsafe}fn {name}{self.parameters(inner['generics']['params'])}"
            f"({', '.join(inputs)}){self.returned(sig['output'])}{self.where(*generics)}"
        )

    def add(self, path, line, implements=False):
        self.lines.append((path, implements, line))

    def declared(self, path, item, kind, inner):
        """The line of an item that has generics, but for what is particular to its kind."""
        closed = "#[non_exhaustive] " if "non_exhaustive" in str(item["attrs"]) else ""
        return f"{closed}{kind} {path}{self.parameters(inner['generics']['params'])}"

    def list(self, key, path):
        item, kind, inner = self.item(key)
        short = {"function": "fn", "type_alias": "type", "constant": "const"}.get(kind, kind)
        self.counts[short] += 1
        if kind == "module":
            self.add(path, f"mod {path}")
        elif kind == "function":
            self.add(path, self.function(path, inner))
        elif kind in ("constant", "static"):
            self.add(path, f"{short} {path}: {self.type(inner['type'])}")
        elif kind == "type_alias":
            declared = self.declared(path, item, "type", inner)
            self.add(path, f"{declared} = {self.type(inner['type'])}")
        elif kind == "macro":
            self.add(path, f"macro {path}!")
        elif kind == "struct":
            self.add(path, self.declared(path, item, kind, inner) + self.fields(inner["kind"])
                     + self.where(inner["generics"]))
            self.implementations(path, inner["impls"])
        elif kind == "enum":
            self.add(path, self.declared(path, item, kind, inner) + self.where(inner["generics"]))
            for each in inner["variants"]:
                variant, _, body = self.item(each)
                if variant is not None:
                    name = f"{path}::{variant['name']}"
                    self.add(name, f"variant {name}{self.fields(body['kind'])}")
            self.implementations(path, inner["impls"])
        elif kind == "trait":
            bounds = f": {self.bounds(inner['bounds'])}" if inner["bounds"] else ""
            self.add(path, self.declared(path, item, kind, inner) + bounds
                     + self.where(inner["generics"]))
            self.associated(path, inner["items"])
            self.implementations(path, inner["implementations"], ours=False)
        else:
            raise ValueError(f"an item of a new kind: {kind}")

    def fields(self, kind):
        """The fields that can be named: ` { x: f32, .. }`, or `(f32, _)`."""
        if kind in ("unit", "plain"):
            return ""
        ((shape, inner),) = kind.items()
        if shape == "tuple":
            types = [self.item(each)[2] if each is not None else None for each in inner]
            return "(" + ", ".join(self.type(each) if each else "_" for each in types) + ")"
        texts = []
        for each in inner["fields"]:
            field, _, of = self.item(each)
            if field is not None:
                texts.append(f"{field['name']}: {self.type(of)}")
        hidden = inner.get("has_stripped_fields")
        return " { " + ", ".join(texts + ([".."] if hidden else [])) + " }"

    def associated(self, path, items):
        """What a trait asks for, and what it provides."""
        for each in items:
            item, kind, inner = self.item(each)
            if item is None:
                continue
            name = f"{path}::{item['name']}"
            if kind == "function":
                provided = "provided " if inner["has_body"] else ""
                self.add(name, provided + self.function(name, inner))
            elif kind == "assoc_const":
                provided = "provided " if inner["value"] is not None else ""
                self.add(name, f"{provided}const {name}: {self.type(inner['type'])}")
            else:
                bounds = f": {self.bounds(inner['bounds'])}" if inner["bounds"] else ""
                self.add(name, f"type {name}{self.parameters(inner['generics']['params'])}{bounds}")

    def implementations(self, path, keys, ours=True):
        """Inherent items, and implementations of traits: for a type of ours, or for others."""
        for key in keys:
            _, _, inner = self.item(key)
            if inner is None or inner["is_synthetic"] or inner["blanket_impl"]:
                continue
            trait, of = inner["trait"], self.type(inner["for"])
            if not ours and self.is_ours(inner["for"]):
                continue
            if trait is None:
                for each in inner["items"]:
                    self.inherent(path, of, each, inner["generics"])
                continue
            hidden = str(trait["id"]) in self.index and str(trait["id"]) not in self.public
            if hidden or trait["path"].endswith("StructuralPartialEq"):
                continue
            types = [self.item(each) for each in inner["items"]]
            types = [
                f"type {item['name']} = {self.type(of_type['type'])}"
                for item, kind, of_type in types
                if kind == "assoc_type"
            ]
            holds = " { " + "; ".join(types) + " }" if types else ""
            parameters = self.parameters(inner["generics"]["params"])
            negative = "!" if inner["is_negative"] else ""
            self.add(path, f"impl{parameters} {negative}{self.path(trait)} for {of}"
                     f"{self.where(inner['generics'])}{holds}", implements=True)

    def is_ours(self, of):
        return "resolved_path" in of and str(of["resolved_path"]["id"]) in self.index

    def conversions(self):
        """Implementations of a trait of others for a type of others: `From<Q15> for f32`."""
        for key, item in self.index.items():
            inner = item["inner"].get("impl")
            if inner and inner["trait"] and str(inner["trait"]["id"]) not in self.index:
                if not self.is_ours(inner["for"]):
                    self.implementations(self.type(inner["for"]), [key])

    def inherent(self, path, of, key, generics):
        item, kind, inner = self.item(key)
        if item is None or item["visibility"] != "public":
            return
        # The bounds of the block are part of what the caller has to meet.
        parameters = self.parameters(generics["params"])
        within = f"impl{parameters} " if parameters else ""
        name = f"{of}::{item['name']}"
        if kind == "function":
            line = self.function(name, inner, outside=generics)
        else:
            line = f"const {name}: {self.type(inner['type'])}"
        self.add(f"{path}::{item['name']}", within + line)

    def text(self):
        found = collections.defaultdict(list)
        self.walk(self.root, [], 0, found)
        # Where it is defined, if a user can name that; otherwise by the fewest re-exports.
        self.public = {key: min(paths)[2] for key, paths in found.items()}
        modules = {
            path
            for key, paths in found.items()
            for _, _, path in paths
            if self.item(key)[1] == "module" and path != self.public[key]
        }
        for key, paths in found.items():
            self.list(key, self.public[key])
            for _, _, path in paths:
                # What is in a module of two names has two of its own; those go without saying.
                if path.rpartition("::")[0] not in modules and path != self.public[key]:
                    self.add(path, f"use {path} = {self.public[key]}")
        self.conversions()
        counts = ", ".join(f"{self.counts[kind]} {kind}" for kind in KINDS)
        total = sum(self.counts[kind] for kind in KINDS)
        head = f"# Written by `bash .ci/run bless_interface`: {total} items ({counts})."
        # An implementation may be listed by its type and by its trait.
        return "\n".join([head] + [line for *_, line in sorted(set(self.lines))]) + "\n"


def main():
    with open(sys.argv[1], encoding="utf-8") as file:
        crate = json.load(file)
    try:
        print(Listing(crate).text(), end="")
    except (KeyError, TypeError, ValueError) as error:
        found = crate["format_version"]
        sys.exit(f"{error!r}: rustdoc's JSON is of format {found}, and this reads {FORMAT}")


if __name__ == "__main__":
    main()
