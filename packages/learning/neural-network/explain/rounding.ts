/**
 * Numbers rounded so that they still add up: the sum is rounded, each part down, and what is missing goes to those that lost most
 * (largest remainder; Hamilton 1792). Each part is less than one unit from its own value. The earlier one wins a tie.
 * @param digits behind the comma, 0..6
 */
export function roundTogether(parts: readonly number[], digits = 0): readonly number[] {
  const unit = UNITS[digits]!
  // What arithmetic leaves over is no remainder.
  const scaled = parts.map((part) => Math.round(part * unit * 1e6) / 1e6)
  const whole = scaled.map(Math.floor)
  const missing = rounded(sum(scaled)) - sum(whole)
  const order = scaled
    .map((part, index) => ({ index, lost: part - whole[index]! }))
    .sort((a, b) => b.lost - a.lost || a.index - b.index)
  for (const { index } of order.slice(0, Math.max(0, missing))) whole[index]!++
  return whole.map((part) => part / unit)
}

const UNITS = [1, 10, 100, 1000, 10_000, 100_000, 1_000_000]

const sum = (numbers: readonly number[]) => numbers.reduce((all, one) => all + one, 0)

/** To the nearest whole number, halves away from zero, as numbers are written on the screen. */
const rounded = (value: number) => {
  const clean = Math.round(value * 1e6) / 1e6
  return Math.sign(clean) * Math.round(Math.abs(clean))
}
