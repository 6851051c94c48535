import { readdirSync, readFileSync } from 'node:fs'
import { join } from 'node:path'

/** Rules that a page's <meta> does not have: who may show it in a frame, and where its forms may send to. */
const frames = "form-action 'self'; frame-ancestors 'self'"

/** For answers that are no page of ours. */
export const baseline = `default-src 'self'; object-src 'none'; base-uri 'none'; ${frames}`

/**
 * The Strict-Transport-Security header; null if the server is not announced under https behind a proxy. In a school's own network
 * https can be switched off again, and devices that remembered it would no longer reach the lab.
 * @param publicOrigin the announced address
 * @param forwarded `X-Forwarded-Proto` of the request
 */
export const transportOf = (publicOrigin: string | null, forwarded: unknown): string | null =>
  publicOrigin?.startsWith('https:') === true && forwarded === 'https' ? 'max-age=15552000' : null

const addressOf = (file: string) => `/${file.replaceAll('\\', '/').replace(/(^|\/)index\.html$|\.html$/, '')}`

function policyOf(html: string) {
  const meta = /<meta http-equiv="content-security-policy" content="([^"]*)">/.exec(html)
  return meta?.[1] === undefined ? baseline : `${meta[1]}; ${frames}`
}

/**
 * The Content Security Policies of prerendered pages: what stands in their <meta>, hashes included, to be sent as a header too.
 * @returns by address, without a slash at the end
 */
export function readPolicies(folder: string): ReadonlyMap<string, string> {
  const files = readdirSync(folder, { recursive: true, encoding: 'utf8' })
  return new Map(
    files
      .filter((file) => file.endsWith('.html'))
      .map((file) => [addressOf(file), policyOf(readFileSync(join(folder, file), 'utf8'))]),
  )
}
