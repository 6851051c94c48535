import type { Context, Frame, Letter } from '../types.ts'

/** The oldest letter of this kind, of one sender or of any, taken out of the box; null where there is none. */
export function takeLetter({ memory }: Context, kind: Letter['kind'], from: string | null): Letter | null {
  const letters = memory.letters()
  const place = letters.findIndex((letter) => letter.kind === kind && (from === null || letter.from === from))
  return place < 0 ? null : (letters.splice(place, 1)[0] ?? null)
}

/** The other robot of a connection. */
export function connectionAt(frame: Frame, k: number): string | null {
  const value = frame.got[k]
  return typeof value === 'string' ? value : null
}
