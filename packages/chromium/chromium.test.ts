import { expect, test } from 'vitest'
import { usualPlaces } from './index.mjs'

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
