// Colour for faces that no part had before, such as the inside of a hollow: the picture goes on through the
// solid as it lies on its surface.
import type { Paint } from './sources.ts';

/** The affine map from place to uv that fits the vertices best (least squares). */
export function fitPaint(positions: Float32Array, uv: Float32Array): Paint {
  const n = positions.length / 3;
  if (uv.length < 2 * n || n < 4) return () => [0.5, 0.5];
  const mean = [0, 0, 0, 0, 0];
  for (let i = 0; i < n; i += 1) {
    for (let k = 0; k < 3; k += 1) mean[k]! += positions[3 * i + k]! / n;
    for (let k = 0; k < 2; k += 1) mean[3 + k]! += uv[2 * i + k]! / n;
  }
  const normal = new Float64Array(9),
    right = new Float64Array(6);
  let scale = 0;
  for (let i = 0; i < n; i += 1) {
    for (let r = 0; r < 3; r += 1) {
      const d = positions[3 * i + r]! - mean[r]!;
      scale += d * d;
      for (let c = 0; c < 3; c += 1) normal[3 * r + c]! += d * (positions[3 * i + c]! - mean[c]!);
      for (let c = 0; c < 2; c += 1) right[2 * r + c]! += d * (uv[2 * i + c]! - mean[3 + c]!);
    }
  }
  // A little stiffness: a flat solid says nothing about the way across it.
  for (let k = 0; k < 3; k += 1) normal[4 * k]! += 1e-6 * scale + 1e-30;
  const [a, b, c, , e, f, , , i] = normal as unknown as [
    number,
    number,
    number,
    number,
    number,
    number,
    number,
    number,
    number,
  ];
  const det = a * (e * i - f * f) - b * (b * i - f * c) + c * (b * f - e * c);
  const inverse = [
    e * i - f * f,
    c * f - b * i,
    b * f - c * e,
    c * f - b * i,
    a * i - c * c,
    b * c - a * f,
    b * f - c * e,
    b * c - a * f,
    a * e - b * b,
  ];
  const weights = [0, 1, 2].map((r) =>
    [0, 1].map((k) => [0, 1, 2].reduce((sum, m) => sum + inverse[3 * r + m]! * right[2 * m + k]!, 0) / det),
  );
  const clamp = (value: number) => Math.min(1, Math.max(0, value));
  return (x, y, z) =>
    [0, 1].map((k) =>
      clamp(
        mean[3 + k]! +
          (x - mean[0]!) * weights[0]![k]! +
          (y - mean[1]!) * weights[1]![k]! +
          (z - mean[2]!) * weights[2]![k]!,
      ),
    ) as [number, number];
}
