import { setTimeout as wait } from 'node:timers/promises'

const pause = 200

/** Somebody with cookies of their own who asks a class server over HTTP, and asks again where nobody answers. */
export class Client {
  /** By their names. */
  readonly cookies = new Map<string, string>()
  private readonly url: string
  private readonly signal: AbortSignal
  /** How often something was sent again. */
  again = 0

  /** @param signal ends everything that is being asked, and all streams */
  constructor(url: string, signal: AbortSignal = new AbortController().signal) {
    this.url = url
    this.signal = signal
  }

  private headers(body: boolean): Headers {
    const headers = new Headers({ origin: this.url })
    if (body) headers.set('content-type', 'application/json')
    const cookie = [...this.cookies].map(([name, value]) => `${name}=${value}`).join('; ')
    if (cookie !== '') headers.set('cookie', cookie)
    return headers
  }

  private keep(answer: Response) {
    for (const line of answer.headers.getSetCookie()) {
      const [, name = '', value = ''] = /^([^=]+)=([^;]*)/.exec(line) ?? []
      this.cookies.set(name, value)
    }
  }

  /** @param body text as it is; anything else as JSON */
  async ask<Answer>(method: string, path: string, body?: unknown): Promise<{ status: number; body: Answer }> {
    const text = body === undefined ? null : typeof body === 'string' ? body : JSON.stringify(body)
    const answer = await fetch(`${this.url}/api/class${path}`, {
      ...{ method, body: text, headers: this.headers(text !== null), signal: this.signal },
    })
    this.keep(answer)
    const given = await answer.text()
    return { status: answer.status, body: (given === '' ? null : JSON.parse(given)) as Answer }
  }

  /** Asks until somebody has answered: a node may be gone, a disk may be busy. @throws after a minute, or when it is ended */
  async untilDone<Answer>(method: string, path: string, body?: unknown): Promise<Answer> {
    for (let tries = 0; tries < 300; tries++) {
      const answer = await this.ask<Answer>(method, path, body).catch(() => null)
      this.signal.throwIfAborted()
      if (answer && answer.status < 300) return answer.body
      if (answer && answer.status < 500) throw new Error(`${method} ${path}: ${answer.status}`)
      this.again++
      await wait(pause)
    }
    throw new Error(`${method} ${path}: nobody answers.`)
  }

  /** Holds a stream of events open until it is stopped, opening it again whenever it ends. */
  listen(path: string, hear: (bytes: number) => void = () => {}): () => void {
    const stop = new AbortController()
    const signal = AbortSignal.any([stop.signal, this.signal])
    const once = async () => {
      const answer = await fetch(`${this.url}/api/class${path}`, { headers: this.headers(false), signal })
      for await (const piece of answer.body ?? []) hear((piece as Uint8Array).length)
    }
    void (async () => {
      while (!signal.aborted) {
        await once().catch(() => {})
        await wait(pause)
      }
    })()
    return () => stop.abort()
  }
}
