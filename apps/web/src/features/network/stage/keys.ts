import { clamp } from '#drawing/points.ts'
import { unitScale, type Scale } from '#drawing/track.ts'

const steps: { readonly [key: string]: number } = { ArrowUp: 1, ArrowRight: 1, ArrowDown: -1, ArrowLeft: -1 }

/** The weight after a key: arrows ±0.05 (±0.1 on a scale to 10), with Shift ±0.2, Home and End its ends. Null for other keys. */
export function stepped(
  { key, shiftKey }: Pick<KeyboardEvent, 'key' | 'shiftKey'>,
  weight: number,
  { least, most, unit }: Scale = unitScale,
): number | null {
  if (key === 'Home') return least
  if (key === 'End') return most
  const step = steps[key]
  if (step === undefined) return null
  const next = weight + step * (shiftKey ? 0.2 : unit === 10 ? 0.1 : 0.05)
  return clamp(Math.round(next * 100) / 100, least, most)
}
