const steps: { readonly [key: string]: number } = { ArrowUp: 1, ArrowRight: 1, ArrowDown: -1, ArrowLeft: -1 }

/** The weight after a key: arrows ±0.05, with Shift ±0.2, Home 0, End 1. Null for other keys. */
export function stepped(
  { key, shiftKey }: Pick<KeyboardEvent, 'key' | 'shiftKey'>,
  weight: number,
): number | null {
  if (key === 'Home') return 0
  if (key === 'End') return 1
  const step = steps[key]
  if (step === undefined) return null
  const next = weight + step * (shiftKey ? 0.2 : 0.05)
  return Math.min(1, Math.max(0, Math.round(next * 100) / 100))
}
