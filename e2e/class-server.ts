// A class server of a test: the complete product on a data folder that nobody has used, asked over HTTP as pages do.
import { mkdtempSync, rmSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import type { Cookie } from '@playwright/test'
import {
  openClassServer,
  startServer,
  type ClassServer,
  type RunningServer,
} from '../packages/server/index.ts'

/** The product as `npm start` opens it. No teacher has made it theirs. @param publicAddress the announced one; none where it is left out */
export async function serverWithData(
  publicAddress?: string,
): Promise<RunningServer & { readonly classServer: ClassServer }> {
  const data = mkdtempSync(join(tmpdir(), 'botgarten-data-'))
  const classServer = await openClassServer({ data, publicAddress })
  const server = await startServer({ port: 0, host: '127.0.0.1', classServer })
  return {
    ...server,
    classServer,
    async close() {
      await server.close()
      rmSync(data, { recursive: true, force: true })
    },
  }
}

interface Answered {
  readonly status: number
  readonly body: unknown
}

/** Somebody with cookies of their own who asks the class server. */
export class Asker {
  private readonly jar = new Map<string, string>()
  private readonly url: string

  constructor(url: string) {
    this.url = url
  }

  /** For `context.addCookies`: a browser in which this one is signed in. */
  get cookies(): Pick<Cookie, 'name' | 'value' | 'domain' | 'path' | 'httpOnly' | 'sameSite'>[] {
    const shared = { domain: new URL(this.url).hostname, path: '/api/class', httpOnly: true } as const
    return [...this.jar].map(([name, value]) => ({ name, value, ...shared, sameSite: 'Lax' }))
  }

  /** @param path below `/api/class` @param body text as it is; anything else as JSON */
  async ask(method: string, path: string, body?: unknown): Promise<Answered> {
    const cookie = [...this.jar].map(([name, value]) => `${name}=${value}`).join('; ')
    const headers = new Headers({ origin: this.url })
    if (body !== undefined) headers.set('content-type', 'application/json')
    if (cookie !== '') headers.set('cookie', cookie)
    const text = body === undefined ? null : typeof body === 'string' ? body : JSON.stringify(body)
    const answer = await fetch(`${this.url}/api/class${path}`, { method, headers, body: text })
    for (const line of answer.headers.getSetCookie()) {
      const [, name = '', value = ''] = /^([^=]+)=([^;]*)/.exec(line) ?? []
      this.jar.set(name, value)
    }
    const given = await answer.text()
    return { status: answer.status, body: given === '' ? null : (JSON.parse(given) as unknown) }
  }
}

interface ClassOfTest extends RunningServer {
  readonly classServer: ClassServer
  /** Signed in as `m.weber`, password `kastanie im regen`. */
  readonly teacher: Asker
  /** The class 5b: English, grade 5, open, joining is open. */
  readonly id: string
  /** Its code as it is typed, such as `kite otter plum`. */
  readonly code: string
  /** A pupil who has just joined. `pictures`: the three in their order. */
  pupil(nickname: string): Promise<{ asker: Asker; id: string; pictures: readonly string[] }>
}

/** Somebody joins a class by its code. */
export async function pupilOf(url: string, code: string, nickname: string) {
  const asker = new Asker(url)
  const { status, body } = await asker.ask('POST', '/join', { code, nickname })
  if (status !== 201) throw new Error(`${nickname} could not join: ${status}`)
  const { id, pictures } = body as { id: string; pictures: readonly string[] }
  return { asker, id, pictures }
}

/** A server with a teacher and an open class. */
export async function classOfTest(
  language: 'en' | 'de' = 'en',
  publicAddress?: string,
): Promise<ClassOfTest> {
  const server = await serverWithData(publicAddress)
  return nextClass({ ...server, teacher: await firstTeacher(server) }, language)
}

/** @returns sets the clock of the server that many days ahead of the one of the machine */
export function setClock({
  classServer: { ports },
}: Pick<ClassOfTest, 'classServer'>): (days: number) => void {
  const { day } = ports
  return (days) => void Object.assign(ports, { day: (offset: number) => day(offset + days) })
}

/** Makes the first teacher of a server, who is signed in. */
export async function firstTeacher({
  url,
  classServer,
}: Pick<ClassOfTest, 'url' | 'classServer'>): Promise<Asker> {
  const teacher = new Asker(url)
  const token = await classServer.firstTeacher()
  await done(teacher, 'POST', '/teachers', { token, username: 'm.weber', password: 'kastanie im regen' })
  return teacher
}

/** One more class 5b on a server that has a teacher. */
export async function nextClass(
  server: Omit<ClassOfTest, 'id' | 'code' | 'pupil'>,
  language: 'en' | 'de',
): Promise<ClassOfTest> {
  const { teacher, url, classServer } = server
  const made = { name: '5b', language, grade: 5, endsOn: classServer.ports.day(120) }
  const { id } = (await done(teacher, 'POST', '/classes', made)) as { id: string }
  await done(teacher, 'POST', `/classes/${id}/open`)
  const { words } = (await done(teacher, 'GET', `/classes/${id}`)) as { words: readonly string[] }
  const code = words.join(' ')
  return { ...{ ...server, id, code }, pupil: (nickname) => pupilOf(url, code, nickname) }
}

async function done(asker: Asker, method: string, path: string, body?: unknown): Promise<unknown> {
  const answer = await asker.ask(method, path, body)
  if (answer.status >= 300) throw new Error(`${method} ${path}: ${answer.status}`)
  return answer.body
}
