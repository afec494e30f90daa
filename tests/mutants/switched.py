"""Planted bugs behind switches: a patch becomes edits of the text, and those of all patches fit into one build.

Old and new text are parsed, and where they differ the smallest statements that hold the difference become
`if (::wander_bugs::on(7)) { new } else { old }`: whole statements, for an operand of another type would change the
type of what surrounds it, with the bug off, too.  A declaration takes with it all that follows in its block.  Outside
of functions a value becomes `(::wander_bugs::on(7) ? (new) : (old))`, and constants of namespaces and classes are
computed when the program starts.  What does not fit, another declaration in a class for example, has no edits.
The lines of a file stay where they are.  Needs tree-sitter (pip install tree-sitter tree-sitter-cpp).
"""
import re
import subprocess
import tempfile
from dataclasses import dataclass, replace
from pathlib import Path

import tree_sitter_cpp
from tree_sitter import Language, Parser

from catalogue import GIT_APPLY, REPOSITORY

PARSER = Parser(Language(tree_sitter_cpp.language()))
STATEMENTS = {"expression_statement", "return_statement", "if_statement", "for_statement", "for_range_loop",
              "while_statement", "do_statement", "switch_statement", "compound_statement", "break_statement",
              "continue_statement", "throw_statement", "try_statement", "comment"}
WITH_A_BODY = {"if_statement", "else_clause", "for_statement", "for_range_loop", "while_statement", "do_statement"}
LISTS = {"argument_list", "initializer_list"}
BEGINNINGS = {"declaration", "field_declaration", "init_declarator", "optional_parameter_declaration"}
FORMS = {"statements": "if ({on}) {{ {new} }} else {{ {old} }}",
         "body": "{{ if ({on}) {{ {new} }} else {{ {old} }} }}",
         "value": "({on} ? ({new}) : ({old}))",
         "constant": "(::wander_bugs::chosen() == {id} ? ({new}) : ({old}))",  # which no compiler computes
         "text": "{new}"}  # whether the bug is on or not


@dataclass(frozen=True)
class Edit:
    """Bytes of the old text, and what stands there when the bug is on."""
    begin: int
    end: int
    new: str
    form: str


class Unfit(Exception):
    """A difference that no switch can hold."""


def edits_of(old, new, wide=False):
    """The edits that make `new` of `old`; `wide`: none within a lambda, whose type may hang on it."""
    found = Comparison(old, new, wide).edits(PARSER.parse(old).root_node, PARSER.parse(new).root_node)
    if not found:
        raise Unfit("neither statements nor a value hold the difference")
    return found


def texts_of(mutant):
    """Of the files that a patch changes, the texts before and after it."""
    names = re.findall(r"^--- a/(\S+)", mutant.path.read_text(), re.MULTILINE)
    before = {name: (REPOSITORY / name).read_bytes() for name in names}
    with tempfile.TemporaryDirectory() as place:
        for name, text in before.items():
            (Path(place) / name).parent.mkdir(parents=True, exist_ok=True)
            (Path(place) / name).write_bytes(text)
        subprocess.run([*GIT_APPLY, "--whitespace=nowarn", mutant.path], cwd=place, check=True)
        return before, {name: (Path(place) / name).read_bytes() for name in names}


def ways_of(mutant):
    """What to try in turn until it compiles: each {file: edits}."""
    before, after = texts_of(mutant)
    ways = []
    for wide in (False, True):
        try:
            way = {name: edits_of(before[name], after[name], wide) for name in before}
        except Unfit:
            continue
        ways += [way] if way not in ways else []
    return ways


def comments_in(node):
    if node.type == "comment":
        return [node]
    return [comment for child in node.children for comment in comments_in(child)]


def trimmed(nodes):
    while nodes and nodes[-1].type == "comment":
        nodes = nodes[:-1]
    return nodes


def around(node, *types):
    """The nearest node around this one that is of these types, or None."""
    node = node.parent
    while node is not None and node.type not in types:
        node = node.parent
    return node


def begins_a_member(node):
    place = around(node, "field_initializer", "compound_statement", "template_argument_list")
    return place is not None and place.type == "field_initializer"


class Comparison:
    def __init__(self, old, new, wide):
        self.old, self.new, self.wide = old, new, wide

    def line(self, nodes):
        """The new text of neighbours without comments, on one line."""
        if not nodes:
            return ""
        pieces, at = [], nodes[0].start_byte
        for comment in (c for node in nodes for c in comments_in(node)):
            pieces.append(self.new[at:comment.start_byte])
            at = comment.end_byte
        text = b" ".join([*pieces, self.new[at:nodes[-1].end_byte]]).decode()
        if re.search(r'^\s*#|R"', text, re.MULTILINE):
            raise Unfit("its lines cannot be joined")
        return " ".join(part.strip() for part in text.split("\n"))

    def edit(self, old, new, form, at=None):
        """Of neighbours; where there are none in the old text, `at` is their place."""
        old, new = trimmed(old), trimmed(new)
        begin = old[0].start_byte if old else at
        return Edit(begin, old[-1].end_byte if old else at, self.line(new), form)

    def edits(self, old, new):
        """The edits within a node that make `new` of it; None if there are none."""
        if old.text == new.text:
            return []
        if old.type != new.type or self.wide and old.type == "lambda_expression":
            return None
        in_switch = old.parent is not None and old.parent.type == "switch_statement"
        if old.type == "case_statement":
            labels = [[n.text for n in node.children].index(b":") for node in (old, new)]
            if [n.text for n in old.children[:labels[0]]] != [n.text for n in new.children[:labels[1]]]:
                return None
        if old.type == "case_statement" or old.type == "compound_statement" and not in_switch:
            return self.of_list(old.children, new.children)
        if old.type == "function_definition":
            old_names, new_names = (n.child_by_field_name("declarator") for n in (old, new))
            if old_names and new_names and old_names.text != new_names.text:
                return self.of_function(old, new, old_names, new_names)
        if old.type == "field_declaration_list" and len(new.children) > len(old.children):
            return self.of_class(old, new)
        return self.of_children(old.children, new.children, old) or self.of_value(old, new)

    def of_class(self, old, new):
        """A member that only the bug has is there without it, too."""
        kept, added, rest = [], [], list(old.children)
        for node in new.children:
            if node.type == "field_declaration" and node.text not in [n.text for n in old.children]:
                added.append(Edit(rest[0].start_byte, rest[0].start_byte, self.line([node]) + " ", "text"))
            else:
                kept.append(node)
                rest = rest[1:]
        found = self.of_children(old.children, kept, old)
        return None if found is None else added + found

    def of_children(self, old, new, parent):
        if len(old) != len(new):
            return None
        found = []
        for a, b in zip(old, new):
            edits = self.edits(a, b)
            if edits is None and parent.type in WITH_A_BODY and a.type in STATEMENTS and b.type in STATEMENTS:
                edits = [self.edit([a], [b], "body")]
            if edits is None and parent.type in LISTS and begins_a_member(parent) and a.is_named and a.type not in LISTS:
                edits = [self.edit([a], [b], "value")]
            if edits is None:
                return None
            found += edits
        return found

    def of_list(self, old, new):
        """Statements of a block or a case."""
        head = 0
        while head < min(len(old), len(new)) and old[head].text == new[head].text:
            head += 1
        tail = 0
        while tail < min(len(old), len(new)) - head and old[-1 - tail].text == new[-1 - tail].text:
            tail += 1
        # Of a block the brace at its end is no statement, of a case there is none.
        last = -1 if old[-1].type == "}" else None
        a, b = old[head:len(old) - tail], new[head:len(new) - tail]
        if len(a) != len(b):
            if all(node.type in STATEMENTS for node in a + b):
                at = old[len(old) - tail].start_byte if tail else old[-1].end_byte
                return [self.edit(a, b, "statements", at)]
            return [self.edit(old[head:last], new[head:last], "statements", old[-1].start_byte)]
        found = []
        for k, (x, y) in enumerate(zip(a, b), head):
            edits = self.edits(x, y)
            if edits is None and not (x.type in STATEMENTS and y.type in STATEMENTS):
                return found + [self.edit(old[k:last], new[k:last], "statements")]
            found += [self.edit([x], [y], "statements", x.start_byte)] if edits is None else edits
        return found

    def of_function(self, old, new, old_head, new_head):
        """Where only names of parameters come or go the fuller list of them serves both bodies."""
        words = [re.findall(r"\w+", node.text.decode()) for node in (old_head, new_head)]
        fewer, more = sorted(words, key=len)
        rest = iter(more)
        bodies = [node.child_by_field_name("body") for node in (old, new)]
        same = old_head.named_child_count == new_head.named_child_count and None not in bodies
        if not same or len(fewer) == len(more) or not all(word in rest for word in fewer):
            return None
        if old_head.text.count(b",") != new_head.text.count(b","):
            return None
        found = self.edits(*bodies)
        if found is None or more is words[0]:
            return found
        return [self.edit([old_head], [new_head], "text"), *found]

    def of_value(self, old, new):
        """What a constant, a member or a parameter is without a word: all of it, whose type is the variable's."""
        if old.type not in BEGINNINGS or around(old, "compound_statement"):
            return None
        pairs = [(a, b) for a, b in zip(old.children, new.children) if a.text != b.text]
        if len(old.children) != len(new.children) or len(pairs) != 1:
            return None
        (a, b), = pairs
        before = a.prev_sibling
        if before is None or before.type != "=" or a.type in LISTS or b.type in LISTS:
            return None
        constant = self.of_constant(old.parent if old.type == "init_declarator" else old)
        return None if constant is None else [self.edit([a], [b], "constant" if constant else "value"), *constant]

    def of_constant(self, statement):
        """`constexpr` becomes `const`, within a class also `inline`; None where types or sizes may hang on it."""
        for node in statement.children:
            if node.text == b"constexpr":
                if statement.child_by_field_name("type").text != b"double":
                    return None
                word = "inline const" if statement.type == "field_declaration" else "const"
                return [Edit(node.start_byte, node.end_byte, word, "text")]
        return []


def together(wanted, source):
    """[(id, edit)] in the order in which they are written; neighbours that overlap reach as far as the last."""
    ordered = sorted(wanted, key=lambda item: (item[1].begin, -item[1].end))
    for k, (id, edit) in enumerate(ordered):
        for _, later in ordered[k + 1:]:
            if edit.begin < later.begin < edit.end < later.end:
                rest = re.sub(r"\s*(//[^\n]*)?\n\s*", " ", source[edit.end:later.end].decode())
                edit = replace(edit, end=later.end, new=edit.new + rest)
        ordered[k] = id, edit
    return sorted(ordered, key=lambda item: (item[1].begin, -item[1].end))


def rewritten(source, wanted):
    """The text with all of `wanted`, [(id, edit)], each within those around it."""
    ordered = together(wanted, source)

    def text(begin, end, inside):
        parts, at = [], begin
        while inside:
            (id, edit), inside = inside[0], inside[1:]
            inner = [item for item in inside if item[1].end <= edit.end and item[1].begin < edit.end]
            inside = inside[len(inner):]
            old = text(edit.begin, edit.end, inner)
            switched = FORMS[edit.form].format(id=id, on=f"::wander_bugs::on({id})", new=edit.new, old=old)
            parts += [source[at:edit.begin].decode(), switched]
            at = edit.end
        return "".join(parts) + source[at:end].decode()

    return text(0, len(source), ordered)
