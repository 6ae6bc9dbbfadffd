"""Laws of the training: python3 -m unittest test_train."""
import unittest

import torch

from train import REACHED, augment


class Augmented(unittest.TestCase):
    def test_truth_goes_with_its_row(self):
        """A mark that stands at the true label of every row stands there after rows and sides have changed places."""
        rng = torch.Generator().manual_seed(3)
        rows, levels, mark = 16, 32, 4
        for _ in range(40):
            t = torch.randint(1, levels, (8, 2, rows), generator=rng).float()
            x = torch.zeros(8, 2, rows, levels, 16)
            x[..., REACHED] = 1
            x[..., mark].scatter_(-1, t.long().unsqueeze(-1), 1)
            y, known = augment(x, t, rng)
            seen = y[..., mark].amax(-1) > 0.5  # no hole lies over it
            self.assertGreater(seen.float().mean().item(), 0.9)
            self.assertTrue((y[..., mark].argmax(-1).float() == known)[seen].all())


if __name__ == "__main__":
    unittest.main()
