import * as v from 'valibot'

const answer = v.object({ port: v.pipe(v.number(), v.integer(), v.minValue(1), v.maxValue(65_535)) })

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
