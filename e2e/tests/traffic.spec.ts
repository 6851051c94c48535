// Rooms: app, class
import { readFileSync } from 'node:fs'
import { startServer } from '../../packages/server/index.ts'
import { classOfTest } from '../class-server.ts'
import { expect, test } from '../house.ts'
import { trafficOf } from '../traffic.ts'

// Work must not be lost: a fault here gets no further try.
test.describe.configure({ retries: 0 })

test.use({ serviceWorkers: 'allow', complaints: [/^A request to http:\/\/localhost:\d+\//] })

const built = new URL('../../apps/web/.svelte-kit/output/client/.vite/manifest.json', import.meta.url)
const manifest = JSON.parse(readFileSync(built, 'utf8')) as {
  readonly [source: string]: { readonly file: string; readonly imports?: readonly string[] }
}

/** Scripts that come with these sources. */
function scriptsWith(sources: readonly string[], found = new Set<string>()): ReadonlySet<string> {
  for (const source of sources) {
    const { file, imports = [] } = manifest[source]!
    if (found.has(file)) continue
    found.add(file)
    scriptsWith(imports, found)
  }
  return found
}

// What is fetched for times without a network comes after the page stands, through the service worker, and is counted apart:
// offline.spec.ts.
test('the whole lab comes in at most 40 requests and 0.8 MB', async ({ page, child }) => {
  const { requests, bytes } = await trafficOf(page, '/lab/friendship', () => child.seesBlocks())
  expect(requests).toBeGreaterThan(1)
  expect(requests).toBeLessThanOrEqual(40)
  expect(bytes).toBeGreaterThan(10_000)
  expect(bytes).toBeLessThanOrEqual(800_000)
})

test('without a class or a study nothing of it travels, and the lab has not a byte more than where there is no class server', async ({
  page,
  child,
}) => {
  const asked: string[] = []
  page.on('request', (request) => asked.push(new URL(request.url()).pathname.slice(1)))
  const alone = await startServer({ port: 0, host: '127.0.0.1', classServer: null })
  const beside = await classOfTest()
  const of = (url: string) => trafficOf(page, `${url}/lab/friendship`, () => child.seesBlocks())
  const [first, second] = [await of(alone.url), await of(beside.url)]
  expect(second).toEqual(first)
  // By address: the first load of home.
  await page.goto(`${beside.url}/`, { waitUntil: 'networkidle' })

  const travelled = new Set(asked)
  const pages = Object.keys(manifest).filter(
    (source) => /nodes\/\d+\.js$/.test(source) && travelled.has(manifest[source]!.file),
  )
  expect(pages.length).toBeGreaterThan(1)
  const ofPages = scriptsWith(pages)
  for (const part of ['class', 'gallery', 'study'].map((name) => `src/features/${name}/lazy.ts`)) {
    const ofPart = [...scriptsWith([part])].filter((file) => !ofPages.has(file))
    expect(ofPart).toContain(manifest[part]!.file)
    expect(ofPart.filter((file) => travelled.has(file))).toEqual([])
  }
  for (const server of [alone, beside]) await server.close()
})
