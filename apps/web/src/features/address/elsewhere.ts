import { parseUrl } from '@botgarten/browsers'
import { isOwnMachine, type Place } from '#parts/page/address.ts'

const noted = 'botgarten.stays'

/** Has the child chosen in this tab to stay under this address? */
function stays(): boolean {
  try {
    return sessionStorage.getItem(noted) !== null
  } catch {
    return false
  }
}

/** In this tab it is not asked again. */
export function stay(): void {
  try {
    sessionStorage.setItem(noted, 'yes')
  } catch {
    // It is asked once more then.
  }
}

type Fetch = (path: string) => Promise<Response>

const originIn = (body: unknown): string | null => {
  const address = typeof body === 'object' && body !== null && 'address' in body ? body.address : null
  return typeof address === 'string' && /^https?:\/\//.test(address)
    ? (parseUrl(address)?.origin ?? null)
    : null
}

/**
 * Browsers keep work by address, so each room has one that counts. The machine of the server itself is no other device.
 * @returns the announced address where this page is under another one; null where it is right, or nobody knows better
 */
export async function announcedElsewhere(
  { hostname, origin }: Place,
  fetch: Fetch = globalThis.fetch,
): Promise<string | null> {
  if (__WEB_SPACE__ || isOwnMachine(hostname) || stays()) return null
  const response = await fetch('/api/class/state').catch(() => null)
  if (response?.status !== 200) return null
  const announced = originIn(await response.json().catch(() => null))
  return announced === origin ? null : announced
}
