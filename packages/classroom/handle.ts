import { bodyOf, mostOfProject } from './body.ts'
import { codeOf, refusalOfDatabase } from './database/errors.ts'
import { newToken } from './hashes.ts'
import { cookie, cookieIn, deviceCookie, pupilCookie } from './joining/cookies.ts'
import { networkOf } from './joining/network.ts'
import type { Pupil } from './joining/sessions-store.ts'
import type { Limits } from './limits.ts'
import type { Caller, Ports } from './ports.ts'
import { Refusal, WrongTry } from './refusal.ts'
import type { Call, Route } from './route.ts'
import { findRoute, type Found } from './routes.ts'
import { whoAsks } from './who.ts'

export const base = '/api/class'

/** Pages of others must not make a browser change anything: what changes something says where it comes from. */
function refuseForeign({ method, headers, url }: Request, publicOrigin: string | null): void {
  if (method === 'GET') return
  // Browsers that name it know more than an origin tells: whether the schemes are the same.
  const site = headers.get('sec-fetch-site')
  if (site !== null && site !== 'same-origin' && site !== 'none') throw new Refusal(403, 'foreignPage')
  const origin = headers.get('origin')
  if (origin !== null && URL.canParse(origin)) {
    if (publicOrigin !== null && origin === publicOrigin) return
    if (new URL(origin).host === (headers.get('host') ?? new URL(url).host)) return
  }
  throw new Refusal(403, 'foreignPage')
}

function json(status: number, body: unknown, cookies: readonly string[] = []): Response {
  const headers = new Headers({ 'cache-control': 'no-store' })
  for (const one of cookies) headers.append('set-cookie', one)
  if (body === undefined) return new Response(null, { status: status === 200 ? 204 : status, headers })
  headers.set('content-type', 'application/json; charset=utf-8')
  return new Response(JSON.stringify(body), { status, headers })
}

/** better-auth's cookies know nothing of https, which may end at a proxy. */
function dressed(response: Response, { secure }: Caller): Response {
  const headers = new Headers(response.headers)
  headers.set('cache-control', 'no-store')
  headers.delete('set-cookie')
  for (const one of response.headers.getSetCookie())
    headers.append('set-cookie', secure && !/; *secure/i.test(one) ? `${one}; Secure` : one)
  return new Response(response.body, { status: response.status, headers })
}

async function answerTo(request: Request, found: Found, ports: Ports, caller: Caller): Promise<Response> {
  const { route, at } = found
  const { headers } = request
  refuseForeign(request, ports.publicOrigin)
  const session = route.roles.includes('pupil') ? cookieIn(headers, pupilCookie) : null
  ports.limits.refuseEarly(session)
  const who = await whoAsks(ports, route.roles, headers, at['class'])
  const { pupil } = who
  if (pupil) countRequest(ports.limits, pupil, session)
  const uploaded = isUpload(route) && pupil ? ports.limits.upload(pupil, bytesIn(headers)) : null
  try {
    return await answerOf(request, found, { ports, caller, who })
  } finally {
    uploaded?.()
  }
}

function countRequest(limits: Limits, pupil: Pupil, session: string | null): void {
  try {
    limits.requestOf(pupil)
  } catch (error) {
    if (session !== null && error instanceof Refusal)
      limits.noteRefused(session, Number(error.facts['seconds']))
    throw error
  }
}

const isUpload = ({ body }: Route) => body === 'project'

/** Bytes that a request announces; as many as it may have, if it announces none. */
const bytesIn = (headers: Headers) => Number(headers.get('content-length') ?? mostOfProject)

async function answerOf(
  request: Request,
  { route, at }: Found,
  { ports, caller, who }: Pick<Call<unknown>, 'ports' | 'caller' | 'who'>,
): Promise<Response> {
  const { headers } = request
  const body = await bodyOf(request, route)
  if (who.pupil && isUpload(route)) ports.limits.sent(who.pupil.id, (body as string).length)
  const query = new URL(request.url).searchParams
  const triers = { device: cookieIn(headers, deviceCookie), address: networkOf(caller.address) }
  const answer = await route.handle({ ports, who, at, query, body, headers, caller, triers })
  if (answer instanceof Response) return dressed(answer, caller)
  return json(answer.status ?? 200, answer.body, answer.cookies)
}

/** A device gets a name with its first wrong try, under which its further ones are counted. */
const cookiesAfter = (refusal: Refusal, { headers }: Request, { random }: Ports, caller: Caller) =>
  refusal instanceof WrongTry && cookieIn(headers, deviceCookie) === null
    ? [cookie(deviceCookie, newToken(random), caller)]
    : []

/** What is thrown, as what is answered. */
function refusalOf(error: unknown): Refusal {
  if (error instanceof Refusal) return error
  return refusalOfDatabase(error) ?? new Refusal(500, 'ourFault')
}

/** After how many seconds the request may succeed; null for a refusal that a retry does not change. */
const secondsUntilRetry = ({ status, facts }: Refusal): number | null =>
  typeof facts['seconds'] === 'number' ? facts['seconds'] : status === 503 ? 5 : null

/** Where an error was made, as `file.ts:12`: its message may hold a name. */
function placeOf({ message, stack = '' }: Error): string {
  const place = /^ +at .*?([\w.-]+:\d+):\d+\)?$/m.exec(stack.replace(message, ''))
  return place ? ` ${place[1]}` : ''
}

const nameOf = (error: unknown) =>
  codeOf(error) || (error instanceof Error ? `${error.name}${placeOf(error)}` : 'unknown')

/** Answers a request to the class: every path below `/api/class`. Never throws. */
export async function handle(request: Request, ports: Ports, caller: Caller): Promise<Response> {
  const { method } = request
  const found = findRoute(method, new URL(request.url).pathname.slice(base.length))
  if (!('route' in found)) {
    if (found.length === 0) return json(404, { error: 'noSuchRoute' })
    const answer = json(405, { error: 'noSuchRoute' })
    answer.headers.set('allow', found.join(', '))
    return answer
  }
  const line = { method, route: found.route.path }
  try {
    const answer = await answerTo(request, found, ports, caller)
    ports.log({ ...line, status: answer.status })
    return answer
  } catch (error) {
    const refusal = refusalOf(error)
    const { status, code, facts } = refusal
    const ours = error instanceof Refusal ? {} : { error: nameOf(error) }
    ports.log({ ...line, status, ...ours })
    const answer = json(status, { error: code, ...facts }, cookiesAfter(refusal, request, ports, caller))
    const seconds = secondsUntilRetry(refusal)
    if (seconds !== null) answer.headers.set('retry-after', String(seconds))
    return answer
  }
}
