import { dev } from '$app/env'
import { immutable } from '$app/manifest'
import { resolve } from '$app/paths'

/** A service worker keeps everything on this device: on https and on the machine itself, not over plain http. */
export const isSheltered = typeof navigator !== 'undefined' && 'serviceWorker' in navigator

const base = () => new URL(resolve('/'), location.href)

export function register(): void {
  if (dev) return
  navigator.serviceWorker
    // The build makes one script without imports of it: as a module Firefox would run it since version 147 only.
    .register(new URL('service-worker.js', base()))
    .catch((cause: unknown) => console.warn('The lab cannot be kept for times without a network.', cause))
}

const idle = (): Promise<unknown> =>
  new Promise((done) => {
    if ('requestIdleCallback' in window) requestIdleCallback(done, { timeout: 2000 })
    else setTimeout(done, 50)
  })

/** Brings one part: scripts and styles to where the page finds them without asking, the rest into the browser's cache. */
async function loadPart(address: string): Promise<void> {
  const link = document.createElement('link')
  link.href = address
  if (address.endsWith('.js')) link.rel = 'modulepreload'
  else if (address.endsWith('.css')) link.rel = 'stylesheet'
  else return void (await (await fetch(address)).arrayBuffer())
  if (document.querySelector(`link[rel="${link.rel}"][href="${CSS.escape(address)}"]`)) return
  await new Promise((done) => {
    link.onload = link.onerror = done
    document.head.append(link)
  })
}

/** How many parts come together: a class of 35 shares one server, and a hand that drags a knob comes first. */
const AT_ONCE = 6

/** Brings all parts of the product, some at a time, so that no click of this page needs the server later. */
export function prefetchParts(): () => void {
  let stopped = false
  const run = async () => {
    for (let at = 0; at < immutable.length; at += AT_ONCE) {
      await idle()
      if (stopped) return
      const some = immutable.slice(at, at + AT_ONCE)
      await Promise.all(some.map(({ path }) => loadPart(new URL(path, base()).href)))
    }
    document.documentElement.dataset['parts'] = 'here'
  }
  run().catch((cause: unknown) => console.warn('Not all parts of the lab could be brought.', cause))
  return () => (stopped = true)
}
