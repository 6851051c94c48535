// Rooms: service-worker
// By address: the subject is a browser without an answer from the server.
import { content } from '@botgarten/content/files'
import type { Page } from '@playwright/test'
import { flags } from '../browser.ts'
import { findChromium } from '../chromium.mjs'
import { Child, leftEye, leftWheel } from '../child.ts'
import { isKept, setsDrivesAndSaves } from '../child-offline.ts'
import { ProjectList } from '../child-projects.ts'
import { guardOf, type Guard } from '../guard.ts'
import { expect, test as base } from '../house.ts'
import { languagesOf } from '../words.ts'

/** A name that leads to this machine: for the browser it is a classroom's server, plain http. */
const classroom = 'classroom.test'

const test = base.extend<{ door: Guard; at: string }>({
  at: ['localhost', { option: true }],
  door: async ({ house }, use) => {
    const door = await guardOf(house)
    await use(door)
    await door.shut()
  },
  baseURL: async ({ door, at }, use) => use(`http://${at}:${door.port}`),
})
// Work must not be lost: a fault here gets no further try.
test.describe.configure({ retries: 0 })
test.use({
  serviceWorkers: 'allow',
  // What the browser itself says about a server that is gone, and addresses of this machine.
  complaints: [
    /ERR_(CONNECTION_REFUSED|INTERNET_DISCONNECTED)|^A request to http:\/\/(localhost|classroom\.test):\d+\//,
  ],
  launchOptions: {
    executablePath: findChromium() ?? undefined,
    args: [...flags, `--host-resolver-rules=MAP ${classroom} 127.0.0.1`],
  },
})

for (const language of languagesOf(import.meta.filename)) {
  test.describe(`the cable is pulled, in ${language}`, () => {
    test.use({ language })

    test('after one visit to home, over localhost, the lab starts, drives and keeps', async ({
      child,
      page,
      door,
    }) => {
      await child.opensHome()
      await isKept(page)
      await door.shut()

      await child.opensLabByAddress('friendship')
      await setsDrivesAndSaves(child)
      await child.reloads()
      await child.seesWeight(leftEye, leftWheel, 0.8)
    })

    test('after one visit to the lab the other pages open, and what is no page leads home', async ({
      child,
      page,
      door,
    }) => {
      await child.opensLabByAddress('friendship')
      await child.typesWeight(leftEye, leftWheel, 0.8)
      await child.seesSaved()
      await isKept(page)
      await door.shut()
      const list = new ProjectList(child)
      await page.goto('/projects')
      await list.seesNames(child.card('friendship'))
      await page.goto('/about')
      await expect(page.getByRole('heading', { level: 1 })).toHaveText(child.word('parts.about'))
      await page.goto('/materials/card/friendship')
      await expect(page.locator('.material[aria-busy="false"]')).toBeVisible()
      await expect(page.getByRole('heading', { level: 1 })).toHaveText(child.card('friendship'))
      await page.goto('/no/such/page')
      await expect(page.getByRole('heading', { level: 1 })).toContainText(child.word('home.title'))
    })

    test('a link opens without a network', async ({ child, page, door }) => {
      await child.opensLabByAddress('friendship')
      await child.typesWeight(leftEye, leftWheel, 0.6)
      await child.seesSaved()
      await child.presses('lab.menu')
      await child.presses('parts.share')
      const link = await new ProjectList(child).link()
      await isKept(page)
      await door.shut()
      await page.goto('/about')
      await page.goto(link)
      await child.seesLab()
      await child.seesWeight(leftEye, leftWheel, 0.6)
    })
  })

  test.describe(`a new version, in ${language}`, () => {
    test.use({ language })

    test('waits while a lab is open, is offered at home and taken by a press', async ({
      child,
      page,
      context,
      door,
    }) => {
      await child.opensHome()
      await isKept(page)
      const before = await page.evaluate(() => caches.keys())
      const version = /botgarten-(\d+)/.exec(before[0] ?? '')?.[1] ?? ''
      const next = String(Number(version) + 1000)
      door.change('/service-worker.js', (text) => text.replaceAll(version, next))

      const lab = new Child(await context.newPage(), language)
      await lab.opensLab('friendship')
      await lab.typesWeight(leftEye, leftWheel, 0.3)
      await lab.seesSaved()
      await child.opensHome()
      await expect(child.words('offline.newVersion')).toBeVisible()
      await child.presses('offline.newVersionTake')
      await expect(child.words('offline.newVersionLab')).toBeVisible()
      await lab.reloads()
      await lab.seesWeight(leftEye, leftWheel, 0.3)
      await expect.poll(() => lab.page.evaluate(() => navigator.serviceWorker.controller !== null)).toBe(true)
      await expect
        .poll(() =>
          page.evaluate(async () => (await navigator.serviceWorker.getRegistration())?.waiting?.state),
        )
        .toBe('installed')

      await lab.page.close()
      await child.presses('offline.newVersionTake')
      await expect
        .poll(() =>
          page
            .evaluate(async () => (await navigator.serviceWorker.getRegistration())?.waiting ?? 'nobody')
            .catch(() => 'the page loads again'),
        )
        .toBe('nobody')
      await child.seesTitle()
      await expect(child.button('offline.newVersionTake')).toBeHidden()
      await expect.poll(() => page.evaluate(() => caches.keys())).toContain(`botgarten-${next}`)
      await door.shut()
      await child.opensLabByAddress('friendship')
      await child.seesWeight(leftEye, leftWheel, 0.3)
    })
  })

  test.describe(`a classroom's server over plain http, in ${language}`, () => {
    test.use({ language, at: classroom })

    test('an open page goes on with the cable pulled: every click finds its part, work is kept, and it says what needs the server', async ({
      child,
      page,
      door,
      context,
    }) => {
      await child.opensHome()
      await expect.poll(() => page.evaluate(() => isSecureContext)).toBe(false)
      await page.waitForFunction(() => document.documentElement.dataset['parts'] === 'here')
      await door.shut()
      await context.setOffline(true)
      await expect(page.getByRole('status').filter({ hasText: child.word('offline.cutOff') })).toBeVisible()
      const asked = door.asked.length

      await child.opensLab('friendship')
      await setsDrivesAndSaves(child)
      await child.presses('lab.menu')
      await child.presses('parts.share')
      await expect(page.getByRole('textbox', { name: child.word('share.address') })).toHaveValue(/\/open#1\./)
      await page
        .getByRole('dialog')
        .getByRole('button', { name: child.word('parts.close') })
        .click()
      await child.presses('lab.menu')
      await page.getByRole('link', { name: child.word('parts.myProjects') }).click()
      const list = new ProjectList(child)
      await list.seesNames(child.card('friendship'))
      await expect(page.getByText(child.word('projects.plainHttp'))).toBeVisible()
      await list.takesHome()
      await list.begins('Maze')
      expect(door.asked.length).toBe(asked)

      await context.setOffline(false)
      await door.open()
      await child.opensLab('friendship')
      await child.seesWeight(leftEye, leftWheel, 0.8)
    })
  })
}

test('the page of the lab is the same for every card but for what that card needs: one is kept for all', async ({
  house,
}) => {
  const names = ['free', ...content.cards.map(({ id }) => id)]
  const ofItsCard =
    /<link href="([^"]+)" rel="modulepreload">(?:<link href="[^"]+" rel="preload" as="fetch" crossorigin><link href="[^"]+" rel="preload" as="image">)?(?=<\/head>)/
  const pages = await Promise.all(
    names.map(async (name) => {
      const answer = await fetch(`${house}/lab/${name}`)
      return answer.ok ? answer.text() : `${name}: ${answer.status}`
    }),
  )
  expect(new Set(pages.map((page) => page.replace(ofItsCard, ''))).size).toBe(1)
  const scripts = pages.slice(1).map((page) => ofItsCard.exec(page)?.[1])
  expect(new Set(scripts).size).toBe(content.cards.length)
  expect(scripts).not.toContain(undefined)
  const script = await fetch(new URL(scripts[0]!, `${house}/lab/free`))
  expect([script.status, await script.text()]).toEqual([200, expect.stringContaining(names[1]!)])
})

test('a browser is told in the first line of the blocks and of the page of the lab to compile them while they travel', async ({
  house,
}) => {
  const page = await (await fetch(`${house}/lab/friendship`)).text()
  const files = [...page.matchAll(/<link href="([^"]+)" rel="modulepreload">/g)].map(([, file]) => file!)
  const scripts = await Promise.all(
    files.map(async (file) => (await fetch(new URL(file, `${house}/lab/friendship`))).text()),
  )
  const largest = scripts.toSorted((a, b) => b.length - a.length)[0]!
  const own = scripts[files.findIndex((file) => /\/nodes\/(?!0\.)/.test(file))]!
  for (const script of [largest, own]) expect(script.split('\n', 1)).toEqual(['//# allFunctionsCalledOnLoad'])
})

test('what is kept for times without a network comes after the page, and is at most 2.75 MB on the wire', async ({
  child,
  page,
  door,
}) => {
  await child.opensLabByAddress('friendship')
  const [requests, bytes] = [door.asked.length, door.bytes]
  expect(door.asked).not.toContain('/service-worker.js')
  await isKept(page)
  expect(door.asked).toContain('/service-worker.js')
  expect(door.asked.length - requests).toBeLessThanOrEqual(440)
  expect(door.bytes - bytes).toBeLessThanOrEqual(2_750_000)
  for (const file of await ownFilesOf(page, '/projects')) expect(door.asked).toContain(file)
  const ofTeachers = await ownFilesOf(page, '/teacher')
  expect(ofTeachers.length).toBeGreaterThan(0)
  for (const file of ofTeachers) expect(door.asked).not.toContain(file)
  // With the server the pages of teachers open as before.
  await page.goto('/teacher')
  await child.seesTitle()
})

/** The scripts that a page has for itself, without the frame of all pages. */
async function ownFilesOf({ request }: Page, address: string): Promise<readonly string[]> {
  const html = await (await request.get(address)).text()
  const links = [...html.matchAll(/<link href="([^"]*\/nodes\/(?!0\.)[^"]+)" rel="modulepreload">/g)]
  return links.map(([, file]) => `/${file!.replace(/^(?:\.*\/)+/, '')}`)
}
