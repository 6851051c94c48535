import type { Caller } from '../ports.ts'

/** Cookies go to the class's routes alone. */
const path = '/api/class'
const days = 24 * 3600

/** The value of a cookie of a request; null where it has none, or one that no cookie of ours can have. */
export function cookieIn(headers: Headers, name: string): string | null {
  const all = (headers.get('cookie') ?? '').split(/; */)
  const value = all.find((one) => one.startsWith(`${name}=`))?.slice(name.length + 1)
  return value !== undefined && /^[\w.-]{1,100}$/.test(value) ? value : null
}

/** A `set-cookie` header; `''` takes the cookie away. Lax: pages of others cannot send it along with what changes something. */
export function cookie(name: string, value: string, { secure }: Caller, seconds = 200 * days): string {
  const age = value === '' ? 0 : seconds
  return `${name}=${value}; Path=${path}; Max-Age=${age}; HttpOnly; SameSite=Lax${secure ? '; Secure' : ''}`
}

export const deviceCookie = 'botgarten-device'
export const pupilCookie = 'botgarten-pupil'
export const substituteCookie = 'botgarten-substitute'
