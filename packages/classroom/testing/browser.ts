import { Events } from './events.ts'

export interface Answered {
  readonly status: number
  readonly body: unknown
  readonly headers: Headers
}

const host = 'http://lab.test'

const isJson = (answer: Response) => answer.headers.get('content-type')?.startsWith('application/json')

/** Speaks to the class as a browser on its page does, and keeps its cookies. */
export class Browser {
  readonly cookies = new Map<string, string>()
  private readonly send: (request: Request) => Promise<Response>

  constructor(send: (request: Request) => Promise<Response>) {
    this.send = send
  }

  get = (path: string) => this.ask('GET', path)
  post = (path: string, body?: unknown) => this.ask('POST', path, body)
  put = (path: string, body: unknown) => this.ask('PUT', path, body)
  patch = (path: string, body: unknown) => this.ask('PATCH', path, body)
  delete = (path: string, body?: unknown) => this.ask('DELETE', path, body)

  /** An answer whose body the caller reads. */
  open = (path: string) => this.raw('GET', path, undefined, {})

  /** @param body text as it is; anything else as JSON */
  async ask(
    method: string,
    path: string,
    body?: unknown,
    headers: Record<string, string> = {},
  ): Promise<Answered> {
    const answer = await this.raw(method, path, body, headers)
    for (const one of answer.headers.getSetCookie()) this.keep(one)
    if (answer.headers.get('content-type') === 'text/event-stream') {
      await answer.body!.cancel()
      return { status: answer.status, body: null, headers: answer.headers }
    }
    const given = await answer.text()
    return {
      status: answer.status,
      body: given === '' ? null : isJson(answer) ? (JSON.parse(given) as unknown) : given,
      headers: answer.headers,
    }
  }

  private async raw(
    method: string,
    path: string,
    body: unknown,
    headers: Record<string, string>,
  ): Promise<Response> {
    const cookie = [...this.cookies].map(([name, value]) => `${name}=${value}`).join('; ')
    const text = body === undefined ? null : typeof body === 'string' ? body : JSON.stringify(body)
    const all = new Headers(headers)
    if (cookie !== '') all.set('cookie', cookie)
    if (method !== 'GET' && !all.has('origin')) all.set('origin', host)
    if (text !== null && !all.has('content-type')) all.set('content-type', 'application/json')
    // As over HTTP, where a sender always names it.
    if (text !== null && !all.has('content-length'))
      all.set('content-length', String(Buffer.byteLength(text)))
    return this.send(
      new Request(`${host}/api/class${path}`, {
        method,
        body: text,
        headers: all,
      }),
    )
  }

  /** Opens a stream of events. */
  async events(path: string): Promise<Events> {
    return new Events(await this.raw('GET', path, undefined, {}))
  }

  private keep(line: string) {
    const [, name, value] = /^([^=]+)=([^;]*)/.exec(line)!
    if (/Max-Age=0/i.test(line)) this.cookies.delete(name!)
    else this.cookies.set(name!, value!)
  }

  /** A second browser with the same cookies. */
  twin() {
    const other = new Browser(this.send)
    for (const [name, value] of this.cookies) other.cookies.set(name, value)
    return other
  }
}
