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

/** Does a Botgarten answer at this port? Any other program answers something else, or nothing. */
async function isBotgarten(port: number, host = 'localhost'): Promise<boolean> {
  try {
    const signal = AbortSignal.timeout(timeout)
    const answer = await fetch(`http://${host}:${port}/api/class/state`, { signal })
    if (answer.status === 204) return true
    const state: unknown = await answer.json()
    return typeof state === 'object' && state !== null && 'firstTeacher' in state
  } catch {
    return false
  }
}

/** Can a server listen at a port? @param host the one address to listen at; all of them where it is missing */
export async function examinePort(port: number, host?: string) {
  const code = await firstError(port, host)
  if (code === null) return fine('port.free', { port })
  if (code === 'EACCES') return wrong('port.forbidden', { port })
  if (code === 'EADDRNOTAVAIL' || code === 'ENOTFOUND') return wrong('port.otherHost', { host: host ?? '' })
  if (code !== 'EADDRINUSE') return wrong('port.failed', { port, why: code })
  return (await isBotgarten(port, host))
    ? fine('port.ours', { port })
    : wrong('port.taken', { port, next: port + 1 })
}
