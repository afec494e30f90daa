"""What becomes of a bug behind a switch: where the switch stands, and that all else is as it was."""
import sys
import unittest
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parent))
try:
    from switched import PARSER, Unfit, edits_of, rewritten, texts_of, ways_of
except ImportError as missing:
    print(f"skipped: {missing.name} is not installed (pip install tree-sitter tree-sitter-cpp)")
    sys.exit(77)
from catalogue import load  # noqa: E402


def both(old, *news, wide=False):
    """`old` with a switch for each of `news`."""
    wanted = [(id, edit) for id, new in enumerate(news) for edit in edits_of(old.encode(), new.encode(), wide)]
    return rewritten(old.encode(), wanted)


def on(id):
    return f"::wander_bugs::on({id})"


class Statements(unittest.TestCase):
    def test_the_smallest_statement_is_there_twice(self):
        self.assertEqual(both("int f() { g(); return 1; }", "int f() { g(); return 0.5; }"),
                         f"int f() {{ g(); if ({on(0)}) {{ return 0.5; }} else {{ return 1; }} }}")

    def test_a_declaration_takes_the_rest_of_its_block(self):
        self.assertEqual(both("void f() { auto x = 1; g(x); }", "void f() { auto x = 2.0; g(x); }"),
                         f"void f() {{ if ({on(0)}) {{ auto x = 2.0; g(x); }} else {{ auto x = 1; g(x); }} }}")

    def test_a_lone_body_keeps_its_else(self):
        self.assertEqual(both("void f() { if (a) g(); else h(); }", "void f() { if (a) k(); else h(); }"),
                         f"void f() {{ if (a) {{ if ({on(0)}) {{ k(); }} else {{ g(); }} }} else h(); }}")

    def test_a_condition_takes_its_statement(self):
        self.assertEqual(both("void f() { while (a) g(); }", "void f() { while (b) g(); }"),
                         f"void f() {{ if ({on(0)}) {{ while (b) g(); }} else {{ while (a) g(); }} }}")

    def test_what_is_left_out_and_what_is_added(self):
        self.assertEqual(both("void f() { g(); h(); }", "void f() { h(); }", "void f() { g(); k(); h(); }"),
                         f"void f() {{ if ({on(0)}) {{  }} else {{ g(); }} "
                         f"if ({on(1)}) {{ k(); }} else {{  }}h(); }}")

    def test_a_statement_stands_where_a_last_comment_was(self):
        self.assertEqual(both("void f() { g();  // g\n}", "void f() { k();\nreturn; }"),
                         f"void f() {{ if ({on(0)}) {{ k(); }} else {{ g(); }}  "
                         f"if ({on(0)}) {{ return; }} else {{  }}// g\n}}")

    def test_cases_are_statements_of_their_own(self):
        old = "void f() { switch (a) { case 1: g(); break; default: h(); } }"
        self.assertEqual(both(old, old.replace("g()", "k()")),
                         old.replace("g();", f"if ({on(0)}) {{ k(); }} else {{ g(); }}"))
        self.assertTrue(both(old, old.replace("case 1", "case 2")).startswith(f"void f() {{ if ({on(0)})"))

    def test_lines_stay_where_they_are_and_comments_swallow_nothing(self):
        old = "void f() {\n  g(1,\n    2);  // g\n  h();\n}\n"
        new = "void f() {\n  g(1,  // one\n    3);\n  h();\n}\n"
        self.assertEqual(both(old, new), f"void f() {{\n  if ({on(0)}) {{ g(1, 3); }} else {{ g(1,\n    2); }}  // g\n  h();\n}}\n")

    def test_a_lambda_is_left_whole_where_its_type_hangs_on_it(self):
        old = "void f() { g([] { return 1; }); }"
        self.assertIn("[] { if", both(old, old.replace("1", "2.0")))
        self.assertIn("{ g([] { return 2.0; }); }", both(old, old.replace("1", "2.0"), wide=True))


class ManyBugs(unittest.TestCase):
    def test_of_one_statement_are_one_within_the_other(self):
        self.assertEqual(both("void f() { g(); }", "void f() { h(); }", "void f() { k(); }"),
                         f"void f() {{ if ({on(0)}) {{ h(); }} else {{ if ({on(1)}) {{ k(); }} else {{ g(); }} }} }}")

    def test_neighbours_that_overlap_reach_as_far_as_the_last(self):
        shown = both("void f() { a(); b(); c(); }", "void f() { x(); c(); }", "void f() { a(); y(); }")
        self.assertEqual(shown, f"void f() {{ if ({on(0)}) {{ x(); c(); }} else {{ a(); "
                                f"if ({on(1)}) {{ y(); }} else {{ b(); c(); }} }} }}")


class OutsideOfFunctions(unittest.TestCase):
    def test_a_member_begins_as_another_value(self):
        self.assertEqual(both("struct A { A(int x) : x_(x + 1) {} int x_; };", "struct A { A(int x) : x_(x) {} int x_; };"),
                         f"struct A {{ A(int x) : x_(({on(0)} ? (x) : (x + 1))) {{}} int x_; }};")

    def test_a_constant_is_computed_when_the_program_starts(self):
        self.assertEqual(both("inline constexpr double a = 2;", "inline constexpr double a = 3;"),
                         "inline const double a = (::wander_bugs::chosen() == 0 ? (3) : (2));")

    def test_a_parameter_that_only_the_bug_names_has_its_name(self):
        self.assertEqual(both("int f(int) { return 1; }", "int f(int x) { return x; }"),
                         f"int f(int x) {{ if ({on(0)}) {{ return x; }} else {{ return 1; }} }}")

    def test_what_hangs_on_constants_and_classes_does_not_fit(self):
        for old, new in (("constexpr int a = 2;", "constexpr int a = 3;"), ("struct A { int x; };", "struct A { char x; };"),
                         ("int f();", "double f();"), ("int f() { return 1; }", "")):
            self.assertRaises(Unfit, both, old, new)


class Catalogue(unittest.TestCase):
    """With its switch on every bug is what its patch says, but for what is there in either case."""

    def words(self, text):
        leaves, nodes = [], [PARSER.parse(text).root_node]
        while nodes:
            node = nodes.pop()
            if node.type == "parameter_declaration":  # by its type: its name may be there for the other body
                node = node.child_by_field_name("type")
            nodes += reversed(node.children)
            if not node.children and node.type != "comment":
                leaves.append(node.text)
        return [word for word in leaves if word not in (b"constexpr", b"const", b"inline")]

    def test_bugs_are_those_of_their_patches(self):
        for mutant in load():
            before, after = texts_of(mutant)
            for way in ways_of(mutant):
                for name, edits in way.items():
                    with self.subTest(f"{mutant.name}: {name}"):
                        text = before[name]
                        for edit in sorted(edits, key=lambda e: -e.begin):
                            text = text[:edit.begin] + edit.new.encode() + text[edit.end:]
                        self.assertEqual(self.words(text), self.words(after[name]))


if __name__ == "__main__":
    unittest.main()
