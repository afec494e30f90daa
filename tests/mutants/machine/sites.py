"""Where a machine can plant a bug in a file of C++, and the file's text with switches for some of them.

Kinds: another operator (+ -, * /, %), the same of assignments; an order at its boundary; a condition or comparison
negated; an operand of && or || dropped; a number off by one or by an eighth; a truth turned over; a sign dropped;
a statement deleted.  None where the compiler needs constants: arguments of templates, requirements, assertions.
"""
from dataclasses import dataclass

import tree_sitter_cpp
from tree_sitter import Language, Parser

PARSER = Parser(Language(tree_sitter_cpp.language()))
OPERATORS = {"+": "add", "-": "subtract", "*": "multiply", "/": "divide", "%": "remainder"}
ASSIGNMENTS = {"+=": "add_to", "-=": "subtract_from", "*=": "multiply_by", "/=": "divide_by"}
ORDERS = {"<": "less", "<=": "less_equal", ">": "greater", ">=": "greater_equal"}
CONSTANT = {"template_argument_list", "template_parameter_list", "requires_clause", "requires_expression", "ERROR",
            "static_assert_declaration", "concept_definition", "enumerator", "decltype", "alignas_qualifier",
            "noexcept", "attribute_declaration", "attribute_specifier", "preproc_include", "preproc_def",
            "preproc_function_def", "preproc_call", "bitfield_clause", "type_descriptor", "sizeof_expression",
            "user_defined_literal", "explicit_function_specifier", "array_declarator", "throw_statement"}
BARE = {"identifier", "call_expression", "field_expression", "subscript_expression", "parenthesized_expression"}


@dataclass(frozen=True)
class Site:
    """A place of a file, by its bytes, and what would be wrong there."""
    file: str
    begin: int
    end: int
    line: int
    kind: str
    text: str

    @property
    def key(self):
        return f"{self.file}:{self.begin}:{self.kind}"


def operator_of(node):
    found = node.child_by_field_name("operator")
    return found.text.decode() if found else ""


def in_constant_condition(node):
    """`if constexpr (condition)`."""
    return any(child.type == "constexpr" for child in node.children)


def kinds_of(node):
    """The kinds of bugs that a machine can make of `node`."""
    op = operator_of(node)
    parent = node.parent
    if node.type == "binary_expression":
        if op in OPERATORS:
            return ["operator"]
        if op in ORDERS:
            return ["boundary", "negated"]
        if op in ("==", "!="):
            return ["negated"]
        if op in ("&&", "||", "and", "or"):
            return ["left dropped", "right dropped"]
    if node.type == "assignment_expression" and op in ASSIGNMENTS:
        return ["operator"]
    if node.type == "unary_expression" and op in ("-", "!"):
        return ["sign dropped"] if op == "-" else ["negated"]
    if node.type == "number_literal":
        return ["number"]
    if node.type in ("true", "false"):
        return ["turned over"]
    if node.type in BARE and parent is not None:
        is_condition = (parent.type == "condition_clause" and node.is_named
                        or parent.type == "conditional_expression" and parent.child_by_field_name("condition") == node)
        if is_condition:
            return ["negated"]
    if node.type == "expression_statement" and node.named_children and parent.type != "for_statement":
        if node.named_children[0].type in ("call_expression", "assignment_expression", "update_expression"):
            return ["deleted"]
    return []


def sites_of(name, source):
    """All sites of a file, in its order."""
    found = []

    def visit(node):
        if node.type in CONSTANT:
            return
        for kind in kinds_of(node):
            text = " ".join(node.text.decode().split())
            found.append(Site(name, node.start_byte, node.end_byte, node.start_point[0] + 1, kind, text))
        for child in node.children:
            if child.type == "condition_clause" and in_constant_condition(node):
                continue
            visit(child)

    visit(PARSER.parse(source).root_node)
    return found


def rewritten(source, chosen):
    """`source` with a switch for each of `chosen`, {(begin, end, kind): id}; its lines stay where they are."""

    def text(node):
        parts, at = [], node.start_byte
        for child in node.children:
            parts += [source[at:child.start_byte].decode(), text(child)]
            at = child.end_byte
        whole = "".join(parts) + source[at:node.end_byte].decode()
        ids = {kind: chosen[node.start_byte, node.end_byte, kind] for kind in kinds_of(node)
               if (node.start_byte, node.end_byte, kind) in chosen}
        return switched(node, whole, ids, text) if ids else whole

    tree = PARSER.parse(source)
    head = source[:tree.root_node.start_byte].decode()
    return head + text(tree.root_node) + source[tree.root_node.end_byte:].decode()


def switched(node, whole, ids, text):
    op, space = operator_of(node), "::wander_bugs::"
    if node.type in ("binary_expression", "assignment_expression"):
        left = text(node.child_by_field_name("left"))
        right = text(node.child_by_field_name("right"))
        if op in ORDERS:
            return f"{space}{ORDERS[op]}({ids.get('boundary', -1)}, {ids.get('negated', -1)}, {left}, {right})"
        if "operator" in ids:
            name = {**OPERATORS, **ASSIGNMENTS}[op]
            return f"{space}{name}({ids['operator']}, {left}, {right})"
        if op in ("&&", "and", "||", "or"):
            for side in ("left", "right"):
                if f"{side} dropped" in ids:
                    test = f"{space}on({ids[f'{side} dropped']})"
                    operand = left if side == "left" else right
                    operand = f"({test} || ({operand}))" if op in ("&&", "and") else f"(!{test} && ({operand}))"
                    left, right = (operand, right) if side == "left" else (left, operand)
            return f"({left} {op} {right})"
    if "negated" in ids:
        return f"({space}on({ids['negated']}) != static_cast<bool>({whole}))"
    if "turned over" in ids:
        return f"({space}on({ids['turned over']}) != {whole})"
    if "number" in ids:
        return f"{space}number({ids['number']}, {whole})"
    if "sign dropped" in ids:
        return f"{space}negative({ids['sign dropped']}, {text(node.child_by_field_name('argument'))})"
    if "deleted" in ids:
        return f"{{ if (!{space}on({ids['deleted']})) {{ {whole} }} }}"
    raise ValueError(f"{node.type}: {sorted(ids)}")
