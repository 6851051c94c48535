import { firstTeacherToken } from '@botgarten/classroom'
import type { Server } from '@botgarten/classroom/testing'
import { beforeEach, expect, test } from 'vitest'
import { apiOn, freshServer } from '../testing/class-server.ts'
import { classes, made } from './answers.ts'
import type { ClassApi } from './api.ts'
import { joinAddress, codeLabel } from './code.ts'
import { School } from './school.svelte.ts'
import { minutesLeft } from './times.ts'

let server: Server
let api: ClassApi
let school: School
beforeEach(async () => {
  server = await freshServer()
  api = apiOn(server)
  const token = (await firstTeacherToken(server.ports))!
  await api.send('POST', '/teachers', { token, username: 'm.weber', password: 'kastanie im regen' })
  const about = { name: '5b', language: 'en', grade: 5, endsOn: '2027-01-31' }
  school = new School(api, (await api.ask(made, 'POST', '/classes', about)).id)
  await school.load()
})

const allClasses = async () => (await api.ask(classes, 'GET', '/classes')).classes

test('a new class is closed, has a code of four words and is in the list', async () => {
  expect(school.row).toMatchObject({ name: '5b', grade: 5, open: false, joiningUntil: null, pupils: 0 })
  expect(codeLabel(school.row!).split(' ')).toHaveLength(4)
  expect((await allClasses()).map(({ name }) => name)).toEqual(['5b'])
})

test('it opens for twenty minutes, and closes', async () => {
  await school.open()
  expect(minutesLeft(school.row!.joiningUntil, server.now)).toBe(20)
  await school.close()
  expect(school.row).toMatchObject({ open: false })
})

test('the code of the projector page lets a child in; a new code ends it', async () => {
  await school.open()
  const address = new URL(joinAddress('http://lab.test', school.row!))
  expect(address.pathname).toBe('/join')
  const child = await server.pupil(address.hash.slice(1), 'Fuchs')
  expect(child.class).toBe(school.id)
  await school.newCode()
  expect(new URL(joinAddress('http://lab.test', school.row!)).hash).not.toBe(address.hash)
  expect((await server.browser().post('/look', { code: address.hash.slice(1) })).status).toBe(404)
})

test('a pupil gets another name, new pictures, and is removed', async () => {
  await school.open()
  const fox = await server.pupil(school.row!.code, 'Fuchs')
  await server.pupil(school.row!.code, 'Otter')
  await school.load()
  expect(school.pupils.map(({ nickname }) => nickname)).toEqual(['Fuchs', 'Otter'])
  expect(await school.rename(fox.id, 'otter')).toBe(false)
  expect(school.refused).toBe('nicknameTaken')
  expect(await school.rename(fox.id, 'Fuchs 7')).toBe(true)
  expect(school.refused).toBeNull()
  expect(await school.newPictures(fox.id)).toHaveLength(3)
  expect((await fox.browser.get('/me')).status).toBe(401)
  await school.removePupil(fox.id)
  expect(school.pupils.map(({ nickname }) => nickname)).toEqual(['Otter'])
  expect(await school.newPictures(fox.id)).toBeNull()
  expect(school.refused).toBe('noSuchPupil')
})

test('nicknames that others have guessed at are opened by one press', async () => {
  await school.open()
  const { code } = school.row!
  const locked = () => school.pupils.map(({ lockedAt }) => lockedAt !== null)
  for (const nickname of ['Fuchs', 'Otter']) {
    const { pictures } = await server.pupil(code, nickname)
    const wrong = { code, nickname, pictures: pictures.toReversed() }
    for (let count = 0; count < 5; count++) await server.browser().post('/return', wrong)
  }
  await school.load()
  expect(locked()).toEqual([true, true])
  expect(await school.unlockAll()).toBe(true)
  expect(locked()).toEqual([false, false])
})

test('a class is deleted when its name was typed, and only then', async () => {
  expect(await school.deleteAll('5a')).toBe(false)
  expect(school.refused).toBe('otherName')
  expect(await school.deleteAll(' 5b ')).toBe(true)
  expect(await allClasses()).toEqual([])
  expect(server.buried).toEqual([{ kind: 'class', id: school.id }])
})

test('another date has to be one to come', async () => {
  expect(await school.change({ endsOn: '2026-01-31' })).toBe(false)
  expect(school.refused).toBe('endsInThePast')
  await school.change({ name: '5c', grade: 6, endsOn: '2027-07-31' })
  expect(school.row).toMatchObject({ name: '5c', grade: 6, endsOn: '2027-07-31' })
})

test('a link for a substitute lets somebody in, until lending ends', async () => {
  const { token } = (await school.lend())!
  expect(school.refused).toBeNull()
  const other = apiOn(server)
  await other.send('POST', '/substitute', { token })
  await school.endLending()
  await expect(other.send('GET', `/classes/${school.id}`)).rejects.toMatchObject({ status: 401 })
})
