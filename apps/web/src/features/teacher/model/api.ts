import * as v from 'valibot'
import { eventsIn, type Heard } from './events.ts'

/** Why the class server did not do what it was asked. Words for it: `teacher.refused.<code>`. */
export class Refused extends Error {
  /** `noServer`: it cannot be reached, or there is none. */
  readonly code: string
  readonly status: number

  constructor(code: string, status: number) {
    super(code)
    this.code = code
    this.status = status
  }
}

type Method = 'GET' | 'POST' | 'PUT' | 'PATCH' | 'DELETE'
type Fetch = (path: string, init: RequestInit) => Promise<Response>

/** A server that is silent for so long cannot be reached, ms. A start program may be 5 MB. */
const longest = 30_000

const refusal = v.object({ error: v.string() })

async function refusedBy(answer: Response): Promise<Refused> {
  const body: unknown = await answer.json().catch(() => null)
  const given = v.safeParse(refusal, body)
  return new Refused(given.success ? given.output.error : 'noServer', answer.status)
}

/** Speaks to the class server. Every method throws Refused. */
export class ClassApi {
  readonly #fetch: Fetch

  constructor(fetch: Fetch = (path, init) => globalThis.fetch(path, init)) {
    this.#fetch = fetch
  }

  /** A request whose answer counts only as done. */
  async send(method: Method, path: string, body?: unknown): Promise<void> {
    await (await this.#send(method, path, body)).body?.cancel()
  }

  /** A request whose answer is read. An answer of another shape is that of a server that is none of ours. */
  async ask<Schema extends v.GenericSchema>(
    schema: Schema,
    method: Method,
    path: string,
    body?: unknown,
  ): Promise<v.InferOutput<Schema>> {
    const answer = await this.#send(method, path, body)
    const read = v.safeParse(schema, await answer.json().catch(() => null))
    if (!read.success) throw new Refused('noServer', answer.status)
    return read.output
  }

  /** A request whose answer goes on as events. @param signal ends it: the server is told by the broken connection */
  async *events(path: string, body: unknown, signal: AbortSignal): AsyncGenerator<Heard> {
    const answer = await this.#send('POST', path, body, signal)
    try {
      if (answer.body) yield* eventsIn(answer.body, signal)
    } catch {
      throw new Refused('noServer', 0)
    }
  }

  async #send(
    method: Method,
    path: string,
    body: unknown,
    signal = AbortSignal.timeout(longest),
  ): Promise<Response> {
    const json =
      body === undefined
        ? {}
        : { body: JSON.stringify(body), headers: { 'content-type': 'application/json' } }
    const answer = await this.#fetch(`/api/class${path}`, { method, signal, ...json }).catch(() => null)
    if (!answer) throw new Refused('noServer', 0)
    if (!answer.ok) throw await refusedBy(answer)
    return answer
  }
}

export const api = new ClassApi()

/** The code of what was thrown, for the sentence that explains it. */
export const codeOf = (error: unknown): string => {
  if (error instanceof Refused) return error.code
  throw error
}
