import fc from 'fast-check'
import { readFileSync } from 'node:fs'
import { join } from 'node:path'
import { expect, test } from 'vitest'
import { hotspotProfile, joinCode, newPassword } from './hotspot.ts'
import { readSettings } from './settings.ts'

const usual = { country: 'DE', hotspot: 'Botgarten', password: '', language: 'de', https: false }

test('the settings that the image brings are the usual ones', () => {
  expect(readSettings(readFileSync(join(import.meta.dirname, '../boot/botgarten.txt'), 'utf8'))).toEqual(
    usual,
  )
})

test('settings are read as an editor of Windows saves them', () => {
  const text =
    '\uFEFF# Schule\r\ncountry=AT\r\n hotspot = Robo=1 \r\npassword=kastanie im regen\r\nlanguage=en\r\nhttps=yes\r\n'
  expect(readSettings(text)).toEqual({
    ...{ country: 'AT', hotspot: 'Robo=1', password: 'kastanie im regen', language: 'en', https: true },
  })
})

test('what cannot be used is as usual: the Pi starts in any case', () => {
  const text = `country=Germany\nhotspot=${'ü'.repeat(17)}\npassword=short\nlanguage=fr\nhttps=no\nshell=yes`
  expect(readSettings(text)).toEqual(usual)
  fc.assert(
    fc.property(fc.string({ unit: 'binary' }), (any) => {
      const found = readSettings(any)
      expect(found.hotspot).not.toBe('')
      expect(Buffer.byteLength(found.hotspot)).toBeLessThanOrEqual(32)
    }),
  )
})

test('a password that is made has twelve letters that are told apart', () => {
  expect(newPassword()).toMatch(/^[a-hjkmnp-z346789]{4}(-[a-hjkmnp-z346789]{4}){2}$/)
  expect(newPassword(() => 0)).toBe('aaaa-aaaa-aaaa')
})

test('names and passwords cannot add a line to the profile of the hot spot', () => {
  const wanted = fc.tuple(fc.string({ unit: 'binary' }), fc.string())
  const lines = (name: string, password: string) => hotspotProfile(name, password).split('\n').length
  const usualLines = lines('Botgarten', 'kastanie')
  fc.assert(
    fc.property(wanted, ([name, password]) => {
      const { hotspot, password: kept } = readSettings(`hotspot=${name}\npassword=${password}`)
      expect(lines(hotspot, kept)).toBe(usualLines)
    }),
  )
  expect(hotspotProfile('Bö', 'a\\bcdefgh')).toMatch(/^ssid=66;195;182;$[^]*^psk=a\\\\bcdefgh$/m)
})

test('the code of a hot spot is what phones read, with letters that mean something marked', () => {
  expect(joinCode('Bot;garten', 'a:b"c\\d,e')).toBe('WIFI:T:WPA;S:Bot\\;garten;P:a\\:b\\"c\\\\d\\,e;;')
})
