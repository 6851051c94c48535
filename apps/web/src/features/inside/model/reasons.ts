import type { Brain, Weights } from '@botgarten/learning/neural-network'
import { roundTogether, sharesOf, type Shares } from '@botgarten/learning/neural-network/explain'

/** An input and what it brings to a neuron, as numbers to be shown. */
export interface Reason {
  readonly id: string
  readonly input: number
  /** Digits behind the comma with which input × weight, as shown, gives the share. */
  readonly digits: number
  /** null: there is more than one link on the way. */
  readonly weight: number | null
  /** As it is. */
  readonly part: number
  /** Rounded together with the others. */
  readonly share: number
}

export interface Reasons {
  readonly rows: readonly Reason[]
  /** What is there without any input; `share` 0: nothing. */
  readonly base: { readonly part: number; readonly share: number }
  /** The rounded shares add up to it exactly. */
  readonly total: number
  /** Digits behind the comma of shares and total. */
  readonly digits: number
}

interface Given {
  readonly id: string
  readonly value: number
  readonly weight: number | null
}

/** The network that is asked. */
interface Asked {
  readonly inputs: readonly { readonly id: string }[]
  readonly brain: Brain
  readonly weights: Weights
}

/** What each input adds to a neuron, with these values at the inputs. */
export function reasonsIn(
  { inputs, brain, weights }: Asked,
  neuron: string,
  values: readonly number[],
): Reasons {
  const direct = brain.layers[1]?.some(({ id }) => id === neuron) ?? false
  const given = inputs.map(({ id }, index) => ({
    ...{ id, value: values[index] ?? 0 },
    weight: direct ? (weights[id]?.[neuron] ?? 0) : null,
  }))
  return reasonsOf(given, sharesOf(brain, values, neuron, weights))
}

/** Shares of a neuron's value as numbers that add up before a child's eyes. */
export function reasonsOf(given: readonly Given[], { shares, base, total }: Shares): Reasons {
  // Small numbers rounded to whole ones would say little.
  const largest = Math.max(Math.abs(total), ...shares.map(Math.abs))
  const digits = largest > 0 && largest < 10 ? 1 : 0
  const rounded = roundTogether([...shares, base], digits)
  const unit = 10 ** digits
  const rows = given.map(({ id, value, weight }, index) => {
    const share = rounded[index]!
    const part = shares[index]!
    return { id, input: value, digits: digitsFor(value, weight, share, unit), weight, part, share }
  })
  const all = rounded.reduce((sum, one) => sum + Math.round(one * unit), 0) / unit
  return { rows, base: { part: base, share: rounded.at(-1)! }, total: all, digits }
}

/** As few digits as make "91 × 0.6 = 55" true of the numbers that are seen. */
function digitsFor(value: number, weight: number | null, share: number, unit: number): number {
  if (weight === null) return 0
  const holds = (digits: number) =>
    Math.abs(Number(value.toFixed(digits)) * weight - share) * unit <= 0.5 + 1e-9
  return [0, 1].find(holds) ?? 2
}

/** The input that brings most; null where none brings anything. */
export const mostOf = ({ rows }: Reasons): Reason | null =>
  rows.reduce<Reason | null>(
    (best, row) => (row.part !== 0 && Math.abs(row.part) > Math.abs(best?.part ?? 0) ? row : best),
    null,
  )

/** A part of a sum as a bar on a line: shares 0..1 of it. */
export interface Part {
  readonly at: number
  readonly width: number
  readonly negative: boolean
}

interface Bars {
  /** Where the line begins. */
  readonly zero: number
  readonly bars: readonly Part[]
}

/** Each part from the beginning on, leftwards where it is negative. */
export function barsOf(parts: readonly number[]): Bars {
  const { zero, whole } = lineOf(parts)
  const bars = parts.map((part) => ({
    at: part < 0 ? zero + part / whole : zero,
    width: Math.abs(part) / whole,
    negative: part < 0,
  }))
  return { zero, bars }
}

/** All parts end to end: what lies right of the beginning is added, what lies left taken away. */
export function endToEnd(parts: readonly number[]): Bars {
  const { zero, whole } = lineOf(parts)
  let [left, right] = [zero, zero]
  const bars = parts.map((part) => {
    const width = Math.abs(part) / whole
    const at = part < 0 ? left - width : right
    if (part < 0) left = at
    else right += width
    return { at, width, negative: part < 0 }
  })
  return { zero, bars }
}

function lineOf(parts: readonly number[]): { readonly zero: number; readonly whole: number } {
  const [positive, negative] = [1, -1].map((sign) =>
    parts.reduce((sum, part) => sum + Math.max(0, part * sign), 0),
  ) as [number, number]
  const whole = positive + negative || 1
  return { zero: negative / whole, whole }
}
