import { firstTeacherToken } from '@botgarten/classroom'
import { expect, test } from 'vitest'
import { apiOn, freshServer } from '../testing/class-server.ts'
import { made } from './answers.ts'
import { isWifi, RoomWifi } from './wifi.svelte.ts'

async function roomOfTeacher() {
  const server = await freshServer()
  const api = apiOn(server)
  const token = (await firstTeacherToken(server.ports))!
  await api.send('POST', '/teachers', { token, username: 'm.weber', password: 'kastanie im regen' })
  const about = { name: '5b', language: 'en', grade: 5, endsOn: '2027-01-31' }
  const { id } = await api.ask(made, 'POST', '/classes', about)
  return () => new RoomWifi(api, id)
}

test('a Wi-Fi is kept by the server, found by another page, and removed', async () => {
  const room = await roomOfTeacher()
  const [here, there] = [room(), room()]
  expect(await here.save({ name: ' Aula ', password: 'sonnenblume' })).toBe(true)
  await there.load()
  expect([here.found, there.found]).toEqual(Array(2).fill({ name: 'Aula', password: 'sonnenblume' }))
  expect(await there.remove()).toBe(true)
  await here.load()
  expect([here.found, there.found]).toEqual([null, null])
})

test('what the server refuses is said, and what was there stays', async () => {
  const room = (await roomOfTeacher())()
  await room.save({ name: 'Aula', password: '' })
  expect(await room.save({ name: 'x', password: 'short' })).toBe(false)
  expect(room.refused).toBe('notUnderstood')
  expect(room.found).toEqual({ name: 'Aula', password: '' })
})

test.each([
  [true, 'Aula', ''],
  [true, 'ä'.repeat(16), 'x'.repeat(63)],
  [false, ' ', ''],
  [false, 'ä'.repeat(17), ''],
  [false, 'Aula', '1234567'],
  [false, 'Aula', 'größer als acht'],
])('the form and the server agree: %s for %s with %s', async (fits, name, password) => {
  expect(isWifi({ name, password })).toBe(fits)
  const room = (await roomOfTeacher())()
  expect(await room.save({ name, password })).toBe(fits)
})
