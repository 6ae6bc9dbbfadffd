"""The network of engine/ribs/learned: the same layers in PyTorch."""
import torch
import torch.nn as nn
import torch.nn.functional as F

CHANNELS = 16
FINE, COARSE = 12, 24


def conv(i, o, stride=(1, 1)):
    return nn.Conv2d(i, o, 3, stride=stride, padding=1)


class Dilated(nn.Conv2d):
    """A dilated 3x3 layer, computed on interleaved grids: oneDNN's bfloat16 gradient of dilated layers is not finite."""

    def __init__(self, width, dilation):
        super().__init__(width, width, 3, padding=1)
        self.apart = dilation

    def forward(self, x):
        d = self.apart
        if d == 1:
            return super().forward(x)
        n, c, rows, columns = x.shape
        x = F.pad(x, (0, -columns % d, 0, -rows % d))
        h, w = x.shape[2:]
        grids = x.reshape(n, c, h // d, d, w // d, d).permute(0, 3, 5, 1, 2, 4).reshape(n * d * d, c, h // d, w // d)
        y = super().forward(grids.contiguous(memory_format=torch.channels_last))
        return y.view(n, d, d, c, h // d, w // d).permute(0, 3, 4, 1, 5, 2).reshape(n, c, h, w)[:, :, :rows, :columns]


class Mix(nn.Module):
    """Own side, other side, and the mean of both over all rows, through one 1x1 layer."""

    def __init__(self, width):
        super().__init__()
        self.layer = nn.Conv2d(3 * width, width, 1)

    def forward(self, x):
        sides = x.unflatten(0, (-1, 2))
        other = sides.flip(1).flatten(0, 1)
        mean = sides.mean(dim=(1, 3), keepdim=True).expand_as(sides).flatten(0, 1)
        return self.layer(torch.cat([x, other, mean], 1))


class Net(nn.Module):
    """(strokes * 2 sides, CHANNELS, rows, levels) -> scores (strokes * 2, rows, levels)."""

    def __init__(self, fine=FINE, coarse=COARSE):
        super().__init__()
        self.enter = conv(CHANNELS, fine, (1, 2))
        self.near = conv(fine, fine)
        self.down = conv(fine, coarse, (2, 2))
        self.join = Mix(coarse)
        self.deep = nn.ModuleList([Dilated(coarse, d) for d in (1, 2, 4)])
        self.rejoin = Mix(coarse)
        self.last = conv(coarse, coarse)
        self.up = nn.Conv2d(coarse, fine, 1)
        self.refine = conv(fine, fine)
        self.out = nn.Conv2d(fine, 2, 1)

    def forward(self, x):
        a = F.relu(self.enter(x))
        a = F.relu(a + self.near(a))
        b = F.relu(self.down(a))
        b = F.relu(b + self.join(b))
        for layer in self.deep:
            b = F.relu(b + layer(b))
        b = F.relu(b + self.rejoin(b))
        b = F.relu(b + self.last(b))
        u = self.up(b).repeat_interleave(2, 2).repeat_interleave(2, 3)
        u = F.relu(a + u)
        u = F.relu(u + self.refine(u))
        y = self.out(u)
        return y.permute(0, 2, 3, 1).flatten(2)

    def layers(self):
        """(name, module) in the order of the weights file."""
        return [("enter", self.enter), ("near", self.near), ("down", self.down), ("join", self.join.layer),
                *((f"deep{i}", layer) for i, layer in enumerate(self.deep)), ("rejoin", self.rejoin.layer),
                ("last", self.last), ("up", self.up), ("refine", self.refine), ("out", self.out)]
