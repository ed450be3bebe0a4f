"""yoke sweep: events beyond those that it keeps are counted, and told."""
import os
import unittest

from harness import Case, ROOT

FOUR_BAR = os.path.join(ROOT, "examples", "four-bar.yaml")
KEPT = 10000


class Events(Case):
    def sweep(self, turns, *words):
        return self.good("sweep", FOUR_BAR, "--over", "theta2=0:%ddeg" % (360 * turns), "--steps", str(4 * turns), "--of",
                         "theta4,gamma,coupler.P.x,coupler.P.y,coupler.B.x,coupler.B.y", *words)

    def test_those_beyond_are_counted(self):
        """As many as the turns have, each the same."""
        once = self.sweep(1, "--format", "json").json()
        self.assertEqual(once["event_total"], len(once["events"]))
        self.assertNotIn("more events", self.sweep(1).out)
        turns = KEPT // len(once["events"]) + 3
        more = turns * len(once["events"]) - KEPT
        self.assertIn("%d more events were found: the first %d are listed" % (more, KEPT), self.sweep(turns).out)


if __name__ == "__main__":
    unittest.main()
