// Rooms: app
import type { Page } from '@playwright/test'
import { expect, test } from '../house.ts'

/** Everything that a page could find of the one before it. */
const foundIn = (page: Page) =>
  page.evaluate(async () => ({
    kept: localStorage.getItem('left'),
    keptByTab: sessionStorage.getItem('left'),
    cookie: document.cookie,
    databases: (await indexedDB.databases()).map(({ name }) => name).filter((name) => name === 'left'),
    script: 'left' in window,
    answer: await (await fetch('/left')).text().then((text) => text === 'left'),
    year: new Date().getFullYear() > 2100,
    permission: (await navigator.permissions.query({ name: 'clipboard-read' as PermissionName })).state,
    moves: matchMedia('(prefers-reduced-motion: no-preference)').matches,
    width: innerWidth,
  }))

const nothing = {
  kept: null,
  keptByTab: null,
  cookie: '',
  databases: [],
  script: false,
  answer: false,
  year: false,
  permission: 'prompt',
  moves: false,
  width: 1366,
}

// One page serves test after test: both are the same test, and whichever comes second would find what the first one left.
test.describe.configure({ mode: 'serial' })
test.use({ complaints: [/status of 404/] })
for (const turn of ['first', 'second'])
  test(`the ${turn} test in a page finds nothing of another one, and leaves all it can`, async ({
    page,
    context,
  }) => {
    await page.goto('/')
    expect(await foundIn(page)).toMatchObject(nothing)

    await page.addInitScript(() => Object.assign(window, { left: true }))
    await context.route('**/left', (route) => route.fulfill({ body: 'left' }))
    await context.addCookies([{ name: 'left', value: 'yes', url: page.url() }])
    await context.grantPermissions(['clipboard-read'])
    await page.emulateMedia({ reducedMotion: 'no-preference' })
    await page.setViewportSize({ width: 500, height: 500 })
    await page.clock.install({ time: new Date('2200-06-01') })
    await page.reload()
    await page.evaluate(async () => {
      localStorage.setItem('left', 'yes')
      sessionStorage.setItem('left', 'yes')
      await new Promise((done) => (indexedDB.open('left').onsuccess = done))
    })
    expect(await foundIn(page)).toMatchObject({
      kept: 'yes',
      keptByTab: 'yes',
      cookie: 'left=yes',
      databases: ['left'],
      script: true,
      answer: true,
      year: true,
      permission: 'granted',
      moves: true,
      width: 500,
    })
  })
