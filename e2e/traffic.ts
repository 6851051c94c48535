import type { Page } from '@playwright/test'

export interface Traffic {
  readonly requests: number
  /** Bytes on the wire, headers included. */
  readonly bytes: number
}

/**
 * What a page asks for when it is opened, until nothing more comes.
 * @param stands resolves when the page is whole; what came last may still be on its way then
 */
export async function trafficOf(page: Page, path: string, stands: () => Promise<unknown>): Promise<Traffic> {
  const session = await page.context().newCDPSession(page)
  await session.send('Network.enable')
  const own = new Set<string>()
  let [requests, bytes] = [0, 0]
  session.on('Network.requestWillBeSent', ({ requestId, request }) => {
    if (/^https?:/.test(request.url)) own.add(requestId)
  })
  session.on('Network.loadingFinished', ({ requestId, encodedDataLength }) => {
    // What the page has already costs nothing.
    if (!own.has(requestId) || encodedDataLength === 0) return
    requests += 1
    bytes += encodedDataLength
  })
  await page.goto(path)
  await stands()
  await page.evaluate(() => document.fonts.ready)
  await page.waitForLoadState('networkidle')
  await session.detach()
  return { requests, bytes }
}
