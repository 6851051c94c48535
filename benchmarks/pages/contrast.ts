import type { Colour } from './seen.ts'

type Opaque = readonly [number, number, number]

const paper: Opaque = [255, 255, 255]

/** The colour that is seen where layers, the topmost first, lie on white paper. */
export const laidOver = (layers: readonly Colour[]): Opaque =>
  layers.reduceRight<Opaque>(
    (below, [r, g, b, a]) => [
      r * a + below[0] * (1 - a),
      g * a + below[1] * (1 - a),
      b * a + below[2] * (1 - a),
    ],
    paper,
  )

const linear = (value: number) => {
  const share = value / 255
  return share <= 0.04045 ? share / 12.92 : ((share + 0.055) / 1.055) ** 2.4
}

/** Relative luminance 0..1, WCAG 2.2. */
const luminance = ([r, g, b]: Opaque) => 0.2126 * linear(r) + 0.7152 * linear(g) + 0.0722 * linear(b)

/** Contrast ratio 1..21, WCAG 2.2. */
export function contrast(a: Opaque, b: Opaque): number {
  const [dark, light] = [luminance(a), luminance(b)].sort((one, other) => one - other) as [number, number]
  return (light + 0.05) / (dark + 0.05)
}
