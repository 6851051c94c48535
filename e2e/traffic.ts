import type { Page } from '@playwright/test'

export interface Traffic {
  readonly requests: number
  /** Bytes on the wire, headers included. */
  readonly bytes: number
}

/** What a page asks for when it is opened, until nothing more comes. */
export async function trafficOf(page: Page, path: string): Promise<Traffic> {
  const session = await page.context().newCDPSession(page)
  await session.send('Network.enable')
  const own = new Set<string>()
  let bytes = 0
  session.on('Network.requestWillBeSent', ({ requestId, request }) => {
    if (/^https?:/.test(request.url)) own.add(requestId)
  })
  session.on('Network.loadingFinished', ({ requestId, encodedDataLength }) => {
    if (own.has(requestId)) bytes += encodedDataLength
  })
  await page.goto(path, { waitUntil: 'networkidle' })
  await session.detach()
  return { requests: own.size, bytes }
}
