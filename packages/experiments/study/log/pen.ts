import type { Entry, Line } from './code-book.ts'
import type { Pen } from './record.ts'
import { TypedTexts } from './typed-texts.ts'

/**
 * Writes lines of one session of one child.
 * @param clock milliseconds since the session began; it never goes back
 */
export function penFor(
  child: { readonly session: string; readonly pseudonym: string },
  clock: () => number,
  put: (line: Line) => void,
): Pen {
  const { session, pseudonym } = child
  const write = (entry: Entry) => put({ t: Math.round(clock()), session, pseudonym, ...entry })
  return { write, texts: new TypedTexts() }
}
