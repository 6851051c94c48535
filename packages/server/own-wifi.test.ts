import { mkdtempSync, rmSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { expect, test } from 'vitest'
import { ownWifi } from './own-wifi.ts'

test('the hot spot of a machine is what its file says; without a file there is none', () => {
  const folder = mkdtempSync(join(tmpdir(), 'botgarten-wifi-'))
  const file = join(folder, 'wifi.json')
  expect(ownWifi({})).toBe(null)
  expect(ownWifi({ BOTGARTEN_WIFI: file })).toBe(null)
  writeFileSync(file, '{"name":"Botgarten","password":"abcd-efgh-jkmn"}')
  expect(ownWifi({ BOTGARTEN_WIFI: file })).toEqual({ name: 'Botgarten', password: 'abcd-efgh-jkmn' })
  rmSync(folder, { recursive: true })
})
