"""What the checks of kept figures say: tools/firmware/tables.py and tools/bench/instructions.py."""
import pathlib
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[1]
sys.dont_write_bytecode = True
sys.path += [str(ROOT / "tools" / "firmware"), str(ROOT / "tools" / "bench")]
import instructions
import tables

EXP, GONE = ("so3_exp", "float"), ("so3_gone", "float")
TABLE = """# a comment
function                        format      M0+    M4F
so3_exp                         float       100    200
so3_exp (textbook, newlib)      float         -    900
so3_gone                        float        50     60
"""


class Tables(unittest.TestCase):
    def growths(self, rows, titles=("M0+", "M4F"), only=()):
        with tempfile.TemporaryDirectory() as directory:
            tables.TABLES = pathlib.Path(directory)
            (tables.TABLES / "stack.txt").write_text(TABLE)
            return list(tables.growths("stack", tables.read_written("stack", titles, only), rows))

    def test_growth_fails_and_the_rest_is_told(self):
        found = self.growths({EXP: {"M0+": 101, "M4F": 199}}, only=["so3_exp"])
        self.assertEqual([grown for grown, _ in found], [True, False, True])
        self.assertIn("100 before, 101 now", found[0][1])
        self.assertIn("textbook, newlib) float, M4F: 900, in the table alone", found[2][1])

    def test_a_function_that_is_no_more_fails(self):
        found = self.growths({EXP: {"M0+": 100}, ("so3_exp (textbook, newlib)", "float"): {}}, titles=["M0+"])
        self.assertEqual(found, [(True, "stack: so3_gone float, M0+: 50, in the table alone")])

    def test_a_new_function_fails(self):
        found = self.growths({("so3_new", "float"): {"M4F": 7}}, only=["so3_new"])
        self.assertEqual(found, [(True, "stack: so3_new float, M4F: 7, not in the table")])

    def test_what_was_not_asked_for_is_not_missed(self):
        self.assertEqual(self.growths({GONE: {"M4F": 60}}, titles=["M4F"], only=["so3_gone"]), [])


class Instructions(unittest.TestCase):
    def test_a_function_on_one_side_alone_is_a_complaint(self):
        found = sorted(instructions.complaints({EXP: [1.0, 1.0]}, {GONE: [1.0, 1.0]}))
        self.assertEqual(found, ["so3_exp float: is in the table alone", "so3_gone float: is not in the table"])


unittest.main()
