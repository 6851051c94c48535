import * as v from 'valibot'

/** What the class server answers. `away`: it cannot be reached, or somebody else answers in its place. */
export type Reply =
  | { readonly kind: 'done'; readonly body: unknown }
  | { readonly kind: 'refused'; readonly status: number; readonly code: string; readonly facts: Facts }
  | { readonly kind: 'away' }

interface Facts {
  readonly revision?: number | undefined
  readonly hash?: string | undefined
  readonly seconds?: number | undefined
  readonly reason?: string | undefined
}

type Method = 'GET' | 'POST' | 'PUT' | 'DELETE'

/** Asks the class server. `body`: text is sent as it is, anything else as JSON. Never throws. */
export type Ask = (method: Method, path: string, body?: unknown) => Promise<Reply>

/** A reply that takes longer will not come: 5 MB through a crowded room take seconds. */
const timeout = 30_000

const number = v.optional(v.number())
const refusal = v.object({
  error: v.string(),
  revision: number,
  hash: v.optional(v.string()),
  seconds: number,
  reason: v.optional(v.string()),
})

type Send = (path: string, init: RequestInit) => Promise<Response>

const send: Send = (path, init) => fetch(path, { ...init, signal: AbortSignal.timeout(timeout) })

const textOf = (body: unknown) => (typeof body === 'string' ? body : JSON.stringify(body))

async function replyIn(response: Response): Promise<Reply> {
  if (response.status === 204) return { kind: 'done', body: null }
  const body: unknown = await response.json()
  if (response.ok) return { kind: 'done', body }
  const found = v.safeParse(refusal, body)
  // A proxy or a page that answers for everything: the class itself always gives a reason.
  if (!found.success) return { kind: 'away' }
  const { error: code, ...facts } = found.output
  return { kind: 'refused', status: response.status, code, facts }
}

/** @param pupil who asks; another one's session then neither gives nor takes anything */
export const askAs =
  (pupil: string | null, sent: Send = send): Ask =>
  async (method, path, body) => {
    try {
      const headers = {
        ...(pupil === null ? {} : { 'botgarten-pupil': pupil }),
        ...(body === undefined ? {} : { 'content-type': 'application/json' }),
      }
      const content = body === undefined ? {} : { body: textOf(body) }
      return await replyIn(await sent(`/api/class${path}`, { method, headers, ...content }))
    } catch {
      return { kind: 'away' }
    }
  }

/** What a reply holds, where it is what was asked for. */
export function read<Schema extends v.GenericSchema>(
  schema: Schema,
  reply: Reply,
): v.InferOutput<Schema> | null {
  if (reply.kind !== 'done') return null
  const found = v.safeParse(schema, reply.body)
  return found.success ? found.output : null
}
