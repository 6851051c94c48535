import { once } from 'node:events'
import { createServer } from 'node:net'
import { causeIn } from '../problem.ts'
import { fine, wrong } from './finding.ts'

/** How long a program on this machine may take to answer, ms. */
const timeout = 2000

async function errorOfListening(port: number, host?: string): Promise<string | null> {
  const server = createServer()
  try {
    server.listen({ port, host })
    await once(server, 'listening')
    return null
  } catch (error) {
    return causeIn(error)
  } finally {
    server.close()
  }
}

/** A program on the machine's own address alone does not keep a server from listening at all of them; pages would reach it. */
const hostsOf = (host?: string) => (host === undefined ? [undefined, '127.0.0.1'] : [host])

async function firstError(port: number, host?: string): Promise<string | null> {
  for (const one of hostsOf(host)) {
    const error = await errorOfListening(port, one)
    if (error !== null) return error
  }
  return null
}

interface State {
  readonly firstTeacher: object | null
  /** A clock that is doubted. Earlier versions do not send it. */
  readonly clock?: { readonly today: string; readonly last: string | null; readonly denied: boolean } | null
}

/** The state of a Botgarten at this port, which may be empty; null: any other program answers something else, or nothing. */
async function stateAt(port: number, host = 'localhost'): Promise<Partial<State> | null> {
  try {
    const signal = AbortSignal.timeout(timeout)
    const answer = await fetch(`http://${host}:${port}/api/class/state`, { signal })
    if (answer.status === 204) return {}
    const state: unknown = await answer.json()
    return typeof state === 'object' && state !== null && 'firstTeacher' in state ? (state as State) : null
  } catch {
    return null
  }
}

/** Does a server at this port wait for an answer about its clock? null: it does not, or there is none. */
export async function examineDoubt(port: number, host?: string) {
  const { today: now, last, denied } = (await stateAt(port, host))?.clock ?? {}
  if (now === undefined || !last) return null
  return wrong(denied ? 'clock.denied' : 'clock.doubted', { now, last })
}

/** Can a server listen at a port? @param host the one address to listen at; all of them where it is missing */
export async function examinePort(port: number, host?: string) {
  const code = await firstError(port, host)
  if (code === null) return fine('port.free', { port })
  if (code === 'EACCES') return wrong('port.forbidden', { port })
  if (code === 'EADDRNOTAVAIL' || code === 'ENOTFOUND') return wrong('port.otherHost', { host: host ?? '' })
  if (code !== 'EADDRINUSE') return wrong('port.failed', { port, why: code })
  return (await stateAt(port, host))
    ? fine('port.ours', { port })
    : wrong('port.taken', { port, next: port + 1 })
}
