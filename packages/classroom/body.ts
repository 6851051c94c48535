import * as v from 'valibot'
import { Refusal } from './refusal.ts'
import type { Route } from './route.ts'

const mostOfForm = 16_000
const mostOfProject = 5_000_000

/** Reads a request's text and stops at the limit, whatever its header says. */
async function textOf(request: Request, most: number): Promise<string> {
  if (Number(request.headers.get('content-length') ?? 0) > most) throw new Refusal(413, 'tooBig', { most })
  const decoder = new TextDecoder('utf-8', { fatal: true })
  const pieces: AsyncIterable<Uint8Array> | [] = request.body ?? []
  let [text, bytes] = ['', 0]
  try {
    for await (const piece of pieces) {
      bytes += piece.length
      if (bytes > most) throw new Refusal(413, 'tooBig', { most })
      text += decoder.decode(piece, { stream: true })
    }
    return text + decoder.decode()
  } catch (error) {
    // Broken UTF-8, or a sender that went away.
    throw error instanceof Refusal ? error : new Refusal(400, 'notUnderstood')
  }
}

function jsonIn(text: string): unknown {
  try {
    return JSON.parse(text)
  } catch {
    throw new Refusal(400, 'notUnderstood')
  }
}

/** PostgreSQL keeps no zero bytes in texts, and nobody types them. */
const hasZero = (text: string) => text.includes('\0') || text.includes('\\u0000')

/** The body as its route wants it. @throws Refusal 400, 413 or 415 where it is something else */
export async function bodyOf(request: Request, { body }: Route): Promise<unknown> {
  if (body === undefined) return undefined
  if (!/^application\/json\b/i.test(request.headers.get('content-type') ?? ''))
    throw new Refusal(415, 'notJson')
  const text = await textOf(request, body === 'project' ? mostOfProject : mostOfForm)
  if (hasZero(text)) throw new Refusal(400, 'notUnderstood')
  if (body === 'project') return text
  const result = v.safeParse(body, jsonIn(text))
  if (!result.success) throw new Refusal(400, 'notUnderstood')
  return result.output
}
