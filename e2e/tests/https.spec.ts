// Rooms: service-worker, server
// By address: a browser without an answer from the server, and the page of the certificate.
import { createHash, X509Certificate } from 'node:crypto'
import { mkdtempSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { flags } from '../browser.ts'
import { isKept, setsDrivesAndSaves } from '../child-offline.ts'
import { findChromium } from '../chromium.mjs'
import { expect, test as base } from '../house.ts'
import { certificatesIn, startServer, type RunningServer } from '../../packages/server/index.ts'

const name = 'botgarten.local'
const data = mkdtempSync(join(tmpdir(), 'botgarten-https-'))
const { authority } = await certificatesIn(data, [name], Date.now())
const { publicKey } = new X509Certificate(authority)
/** How this browser is told to trust the authority, without a store of certificates of its own. */
const trusted = createHash('sha256')
  .update(publicKey.export({ type: 'spki', format: 'der' }))
  .digest('base64')

const test = base.extend<{ room: RunningServer }>({
  // eslint-disable-next-line no-empty-pattern -- Playwright reads the names of what is asked for
  room: async ({}, use) => {
    const room = await startServer({ port: 0, host: '127.0.0.1', https: data })
    await use(room)
    await room.close()
  },
  baseURL: async ({ room }, use) => use(`https://${name}:${room.securePort}`),
})
test.use({
  serviceWorkers: 'allow',
  // What the browser itself says about a server that is gone, and the same server over plain http.
  complaints: [
    /ERR_(CONNECTION_REFUSED|INTERNET_DISCONNECTED)|^A request to https?:\/\/(botgarten\.local|localhost):\d+\//,
  ],
  launchOptions: {
    executablePath: findChromium() ?? undefined,
    args: [
      ...flags,
      `--host-resolver-rules=MAP ${name} 127.0.0.1`,
      `--ignore-certificate-errors-spki-list=${trusted}`,
    ],
  },
})

test('with the authority trusted, the lab starts after one visit with the cable pulled', async ({
  child,
  page,
  room,
}) => {
  await child.opensHome()
  await isKept(page)
  await room.close()

  await child.opensLabByAddress('friendship')
  await setsDrivesAndSaves(child)
})

test('the certificate that devices are to trust is handed out over plain http', async ({ room, request }) => {
  const answer = await request.get(`${room.url}/botgarten.crt`)
  expect(answer.headers()['content-type']).toBe('application/x-x509-ca-cert')
  expect(await answer.text()).toBe(authority)
  expect(await (await request.get(`${room.url}/https.json`)).json()).toEqual({ port: room.securePort })
})

test('a device finds over plain http how to trust the server, and where https is', async ({
  child,
  room,
}) => {
  const { page } = child
  await page.goto(`${room.url}/trust`)
  await expect(page.getByRole('heading', { level: 1 })).toHaveText('Trust the server of this room')
  await expect(page.getByRole('img', { name: /Code of this page/ })).toBeVisible()
  for (const system of ['Windows', 'iPadOS', 'Android', 'ChromeOS', 'macOS'])
    await expect(page.getByRole('heading', { name: system })).toBeVisible()
  // Three steps each, and a picture of each.
  await expect(page.locator('main ol ol svg')).toHaveCount(15)
  await expect(page.getByText(/^To remove it:/)).toHaveCount(5)
  const place = `https://localhost:${room.securePort}`
  await expect(page.getByRole('link', { name: place })).toHaveAttribute('href', place)
})
