import { mkdtempSync, rmSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { afterEach, beforeEach, describe, expect, test, vi } from 'vitest'
import { findChromium, flags, usualPlaces } from './index.mjs'

test('on Linux every folder of PATH is looked through: a Chromium without windows, Chromium, Chrome', () => {
  const places = usualPlaces('linux', { PATH: '/opt/bin:/usr/bin' })
  expect(places[0]).toBe('/opt/bin/chromium-headless-shell')
  expect(places.indexOf('/usr/bin/chromium-headless-shell')).toBeLessThan(places.indexOf('/opt/bin/chromium'))
  expect(places).toContain('/usr/bin/chromium-browser')
  expect(places.indexOf('/usr/bin/chromium')).toBeLessThan(places.indexOf('/opt/bin/google-chrome'))
})

test('on a Mac the applications of the machine and of the person are looked through', () => {
  const places = usualPlaces('darwin', { HOME: '/Users/ada' })
  expect(places).toContain('/Applications/Google Chrome.app/Contents/MacOS/Google Chrome')
  expect(places).toContain('/Users/ada/Applications/Chromium.app/Contents/MacOS/Chromium')
})

test('on Windows the three folders of programs are looked through, as far as there are any', () => {
  const places = usualPlaces('win32', { PROGRAMFILES: 'C:\\Program Files' })
  expect(places).toEqual([
    'C:\\Program Files\\Google\\Chrome\\Application\\chrome.exe',
    'C:\\Program Files\\Microsoft\\Edge\\Application\\msedge.exe',
  ])
})

test('on Linux the folders of the system are looked through without PATH, each once and none that is empty', () => {
  const folders = (env: NodeJS.ProcessEnv) => [
    ...new Set(usualPlaces('linux', env).map((path) => path.replace(/\/[^/]+$/, ''))),
  ]
  expect(folders({})).toEqual(['/usr/bin', '/snap/bin'])
  expect(folders({ PATH: '/usr/bin::/opt/bin' })).toEqual(['/usr/bin', '/opt/bin', '/snap/bin'])
  const names = usualPlaces('linux', { PATH: '/usr/bin' }).map((path) => path.split('/').at(-1))
  expect(new Set(names).size).toBe(6)
  for (const name of names) expect(name).toMatch(/^(chromium|google-chrome|chrome)[a-z-]*$/)
})

test('on a Mac Edge is looked for last', () => {
  expect(usualPlaces('darwin', { HOME: '/Users/ada' }).at(-1)).toBe(
    '/Users/ada/Applications/Microsoft Edge.app/Contents/MacOS/Microsoft Edge',
  )
})

test('Chromium is started without what a container lacks, and talks to nobody else', () => {
  for (const flag of flags) expect(flag).toMatch(/^--[a-z]+(-[a-z]+)+$/)
  expect(new Set(flags).size).toBe(7)
})

describe.runIf(process.platform === 'linux')('the Chromium of this machine', () => {
  let folder: string
  beforeEach(() => {
    folder = mkdtempSync(join(tmpdir(), 'botgarten-chromium-'))
    vi.stubEnv('CHROMIUM', undefined)
    vi.stubEnv('PATH', folder)
  })
  afterEach(() => {
    vi.unstubAllEnvs()
    rmSync(folder, { recursive: true })
  })
  /** A program that answers to `--version` alone, and that with this code. */
  const program = (name: string, code: number) =>
    writeFileSync(join(folder, name), `#!/bin/sh\n[ "$1" = --version ] && exit ${code}\nexit 9\n`, {
      mode: 0o755,
    })
  const first = 'chromium-headless-shell'

  test('is the first one that starts', () => {
    program(first, 0)
    expect(findChromium()).toBe(join(folder, first))
    program(first, 1)
    expect(findChromium()).not.toBe(join(folder, first))
  })

  test('is the one that the environment names, whether it is there or not', () => {
    program(first, 0)
    vi.stubEnv('CHROMIUM', '/opt/my-chromium')
    expect(findChromium()).toBe('/opt/my-chromium')
  })

  test('is one of a place that was named where the system has none', () => {
    program('other', 0)
    program('broken', 1)
    const ofSystem = findChromium()
    expect(findChromium([join(folder, 'missing'), join(folder, 'broken')])).toBe(ofSystem)
    expect(findChromium([join(folder, 'broken'), join(folder, 'other')])).toBe(
      ofSystem ?? join(folder, 'other'),
    )
  })
})
