"""Trains the network on strips (spineloft_strips). See README.md.

train.py STRIPS_GLOB --val VAL_GLOB --out NET.pt [--steps 12400] [--seed 1] [--device cuda]
"""
import argparse
import collections
import concurrent.futures
import copy
import glob
import math
import time

import numpy as np
import torch
import torch.nn.functional as F

from export import read_weights
from model import CHANNELS, Net

REACHED = 14


def load(patterns):
    """Memory maps of all shards: planes (n, 2, rows, levels, channels) int8, exits (n, 2, rows)."""
    shards = []
    for path in sorted(p for pattern in patterns for p in glob.glob(pattern)):
        base = path[: -len(".planes")]
        names = open(base + ".txt").read().splitlines()
        exits = np.fromfile(base + ".exits", np.float32)
        if not names:
            continue
        exits = exits.reshape(len(names), 2, -1)
        planes = np.memmap(path, np.int8, "r").reshape(*exits.shape, -1, CHANNELS)
        shards.append((planes, exits, names))
    return shards


def items(shards):
    """By shape: [(shard, strip)]."""
    groups = {}
    for s, shard in enumerate(shards):
        groups.setdefault(shard[0].shape[1:], []).extend((s, i) for i in range(len(shard[1])))
    return list(groups.values())


def fetch(shards, picks):
    x = np.stack([shards[s][0][i] for s, i in picks])
    t = np.stack([shards[s][1][i] for s, i in picks])
    return torch.from_numpy(x), torch.from_numpy(t)


def picks_of(groups, batch, rng):
    """Batches of one shape each, for ever; every strip of a shape comes before one of it comes again."""
    orders = [[] for _ in groups]
    often = np.sqrt([len(group) for group in groups])
    while True:
        which = rng.choice(len(groups), p=often / often.sum())
        if len(orders[which]) < batch:
            orders[which] = list(rng.permutation(len(groups[which])))
        yield [groups[which][orders[which].pop()] for _ in range(batch)]


def batches(shards, groups, a):
    """Strips and exits of every step on the device, read ahead."""
    picks = picks_of(groups, a.batch, np.random.default_rng(a.seed))
    with concurrent.futures.ThreadPoolExecutor(a.readers) as readers:
        ahead = collections.deque(readers.submit(fetch, shards, next(picks)) for _ in range(2 * a.readers))
        for _ in range(a.steps):
            x, t = ahead.popleft().result()
            ahead.append(readers.submit(fetch, shards, next(picks)))
            yield x.to(a.device).float() / 127, t.to(a.device)


def augment(x, t, rng):
    """In the strip: rows reversed, sides swapped, lightness inverted, hue turned, chroma scaled, noise, holes."""
    n, _, rows, levels, _ = x.shape

    def uniform(low, high):
        return low + (high - low) * torch.rand(n, generator=rng, device=x.device)

    def chance(share):
        return uniform(0, 1) < share

    def each(values):
        return values.view(n, *[1] * (x.dim() - 1))

    for axis in (2, 1):
        turned = chance(0.5)
        x = torch.where(each(turned), x.flip(axis), x)
        t = torch.where(turned.view(n, 1, 1), t.flip(axis), t)
    light = torch.where(chance(0.3), -1.0, 1.0) * uniform(0.8, 1.2)
    angle = uniform(0, 2 * math.pi) * chance(0.7)
    chroma = uniform(0.3, 1.3)
    c, s = chroma * angle.cos(), chroma * angle.sin()
    colour, others = x[..., :3], x[..., 3:]
    turn = torch.zeros(n, 3, 3, device=x.device)
    turn[:, 0, 0], turn[:, 1, 1], turn[:, 1, 2], turn[:, 2, 1], turn[:, 2, 2] = light, c, -s, s, c
    colour = torch.einsum("nij,nsrkj->nsrki", turn, colour)
    x = torch.cat([colour, others], -1)
    noise = uniform(0, 0.03) * chance(0.5)
    x[..., :12] += each(noise) * torch.randn(*x.shape[:-1], 12, generator=rng, device=x.device)
    hole = chance(0.15)
    side, row, level = uniform(0, 2).long(), uniform(0, rows - 14), uniform(0, levels - 30)
    last_row, last_level = row + uniform(2, 14), level + uniform(4, 30)
    at = [torch.arange(size, device=x.device) for size in (2, rows, levels)]
    within = [
        at[0] == side[:, None],
        (at[1] >= row[:, None]) & (at[1] < last_row[:, None]),
        (at[2] >= level[:, None]) & (at[2] < last_level[:, None]),
    ]
    hidden = within[0][:, :, None, None] & within[1][:, None, :, None] & within[2][:, None, None, :]
    seen = (others[..., REACHED - 3] > 0) & ~(hidden & hole.view(n, 1, 1, 1))
    return (x * seen[..., None]).clamp_(-1.2, 1.2), t


def prepared(x):
    """Strips as the network takes them."""
    return x.flatten(0, 1).permute(0, 3, 1, 2)


def log_likelihood(net, x):
    """(strokes, 2, rows, levels); label 0 has none."""
    with torch.autocast(x.device.type, torch.bfloat16):
        y = net(prepared(x))
    y = y.float()
    y = torch.cat([torch.full_like(y[..., :1], -30), y[..., 1:]], -1)
    return F.log_softmax(y, -1).unflatten(0, (-1, 2))


def losses(logp, t):
    """Of every row: cross entropy and expected distance, and whether its truth is known."""
    labels = torch.arange(logp.shape[-1], device=logp.device).float()
    known = t >= 0
    k = torch.where(known, t, torch.zeros_like(t)).unsqueeze(-1)
    target = torch.exp(-0.5 * ((labels - k) / 0.8) ** 2)
    target = target / target.sum(-1, keepdim=True).clamp_min(1e-6)
    ce = -(target * logp).sum(-1)
    far = (logp.exp() * ((labels - k).abs() / 12).clamp(max=1)).sum(-1)
    return ce, far, known.float()


def mean_of(values, known):
    return (values * known).sum() / known.sum().clamp_min(1)


def learning_rate(share, peak):
    return peak * (min(1, share / 0.03) * 0.5 * (1 + math.cos(math.pi * share)) + 0.004)


@torch.no_grad()
def validate(net, shards, device, most=1200):
    """Cross entropy, expected distance, and the share of rows whose best label is within 3; of every shape."""
    net.eval()
    found = []
    for picks in items(shards):
        picks = picks[:: max(1, len(picks) // most)]
        sums = np.zeros(4)
        for i in range(0, len(picks), 32):
            x, t = fetch(shards, picks[i:i + 32])
            x, t = x.to(device).float() / 127, t.to(device)
            logp = log_likelihood(net, x)
            ce, far, known = losses(logp, t)
            close = (logp.argmax(-1) - t).abs() <= 3
            sums += [(v * known).sum().item() for v in (ce, far, close, known)]
        found.append(" ".join(f"{v:.4f}" for v in sums[:3] / sums[3]))
    net.train()
    return ", ".join(found)


def main():
    p = argparse.ArgumentParser()
    p.add_argument("strips", nargs="+")
    p.add_argument("--val", nargs="+", required=True)
    p.add_argument("--out", required=True)
    p.add_argument("--steps", type=int, default=12400)
    p.add_argument("--batch", type=int, default=16)
    p.add_argument("--seed", type=int, default=1)
    p.add_argument("--start", help="a weights file to begin with")
    p.add_argument("--peak", type=float, default=3e-3)
    p.add_argument("--device", default="cpu")
    p.add_argument("--readers", type=int, default=1, help="threads that read strips")
    p.add_argument("--threads", type=int, default=1)
    a = p.parse_args()
    torch.set_num_threads(a.threads)
    torch.manual_seed(a.seed)
    rng = torch.Generator(a.device).manual_seed(a.seed)
    net = Net()
    if a.start:
        read_weights(net, a.start)
    net = net.to(a.device, memory_format=torch.channels_last)
    average = copy.deepcopy(net)
    opt = torch.optim.AdamW(net.parameters(), lr=a.peak, weight_decay=1e-4)
    val, shards = load(a.val), load(a.strips)
    groups = items(shards)
    print([len(group) for group in groups], "strips", flush=True)
    print(sum(q.numel() for q in net.parameters()), "weights", flush=True)
    mean = torch.zeros(2, device=a.device)
    began = time.time()
    for step, (x, t) in enumerate(batches(shards, groups, a), 1):
        for group in opt.param_groups:
            group["lr"] = learning_rate(step / a.steps, a.peak)
        x, t = augment(x, t, rng)
        ce, far, known = losses(log_likelihood(net, x), t)
        both = torch.stack([mean_of(ce, known), mean_of(far, known)])
        opt.zero_grad(set_to_none=True)
        (both[0] + 0.7 * both[1]).backward()
        torch.nn.utils.clip_grad_norm_(net.parameters(), 1.0)
        opt.step()
        keep = min(0.999, 1 - 1 / (1 + step / 10))
        with torch.no_grad():
            for q, w in zip(average.parameters(), net.parameters()):
                q.lerp_(w, 1 - keep)
            mean += 0.02 * (both.detach() - mean)
        if step % 500 == 0:
            minutes = (time.time() - began) / 60
            print(f"{step} in {minutes:.1f} min ce {mean[0].item():.3f} far {mean[1].item():.4f}", flush=True)
        if step % 2000 == 0 or step == a.steps:
            torch.save({k: v.cpu().contiguous() for k, v in average.state_dict().items()}, a.out)
            print(step, "validation", validate(average, val, a.device), flush=True)


if __name__ == "__main__":
    main()
