import * as v from 'valibot'
import { Refusal } from './refusal.ts'
import type { Route } from './route.ts'

const mostOfForm = 16_000
export const mostOfProject = 5_000_000

/** Reads a request's bytes and stops at the limit, whatever its header says. */
async function bytesOf(request: Request, most: number): Promise<Uint8Array> {
  if (Number(request.headers.get('content-length') ?? 0) > most) throw new Refusal(413, 'tooBig', { most })
  const pieces: Uint8Array[] = []
  let length = 0
  for await (const piece of (request.body ?? []) as AsyncIterable<Uint8Array> | []) {
    length += piece.length
    if (length > most) throw new Refusal(413, 'tooBig', { most })
    pieces.push(piece)
  }
  return Buffer.concat(pieces, length)
}

/** Decoded in one go: piece by piece Node makes texts of two bytes a letter, and takes several times as long. */
async function textOf(request: Request, most: number): Promise<string> {
  try {
    return new TextDecoder('utf-8', { fatal: true }).decode(await bytesOf(request, most))
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
export async function bodyOf(request: Request, { body, most = mostOfForm }: Route): Promise<unknown> {
  if (body === undefined) return undefined
  if (!/^application\/json\b/i.test(request.headers.get('content-type') ?? ''))
    throw new Refusal(415, 'notJson')
  const text = await textOf(request, body === 'project' ? mostOfProject : most)
  if (hasZero(text)) throw new Refusal(400, 'notUnderstood')
  if (body === 'project') return text
  const result = v.safeParse(body, jsonIn(text))
  if (!result.success) throw new Refusal(400, 'notUnderstood')
  return result.output
}
