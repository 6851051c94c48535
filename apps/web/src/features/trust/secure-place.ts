import { isOwnMachine, type Place } from '#parts/page/address.ts'
import * as v from 'valibot'

const answer = v.object({ port: v.pipe(v.number(), v.integer(), v.minValue(1), v.maxValue(65_535)) })

const reached = v.object({ addresses: v.array(v.pipe(v.string(), v.url())) })

type Fetch = (path: string) => Promise<Response>

/**
 * Where this server is reached by https; null where it answers none: a lab of files, or one started without `--https`.
 * @param hostname as this device knows the server
 */
export async function securePlace(hostname: string, fetch: Fetch = globalThis.fetch): Promise<string | null> {
  const response = await fetch('/https.json').catch(() => null)
  if (response?.status !== 200) return null
  const read = v.safeParse(answer, await response.json().catch(() => null))
  return read.success ? `https://${hostname}:${read.output.port}` : null
}

/**
 * Where other devices find this page before they trust the server: over plain http.
 * @param at of this page; on the machine of the server no other device gets there
 */
export async function plainPlace(at: Place, fetch: Fetch = globalThis.fetch): Promise<string> {
  if (!isOwnMachine(at.hostname)) return at.origin
  const response = await fetch('/here.json').catch(() => null)
  if (response?.status !== 200) return at.origin
  const read = v.safeParse(reached, await response.json().catch(() => null))
  const others = read.success ? read.output.addresses.map((address) => new URL(address)) : []
  return (
    others.find(({ protocol, hostname }) => protocol === 'http:' && !isOwnMachine(hostname))?.origin ??
    at.origin
  )
}
