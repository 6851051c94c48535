import { firstTeacherToken } from '@botgarten/classroom'
import type { Server } from '@botgarten/classroom/testing'
import { beforeEach, expect, test } from 'vitest'
import { apiOn, freshServer } from '../testing/class-server.ts'
import { Account } from './account.svelte.ts'
import { invitation } from './answers.ts'
import type { ClassApi } from './api.ts'
import { OwnAccount } from './own-account.svelte.ts'
import { fieldOf } from './refused-field.ts'

const password = 'kastanie im regen'
const newClass = { name: '5b', language: 'en', grade: 5, endsOn: '2027-01-31' }

let server: Server
let operator: ClassApi
let teacher: ClassApi
beforeEach(async () => {
  server = await freshServer()
  operator = apiOn(server)
  const first = (await firstTeacherToken(server.ports))!
  await operator.send('POST', '/teachers', { token: first, username: 'm.weber', password })
  const { token } = await operator.ask(invitation, 'POST', '/invitations')
  teacher = apiOn(server)
  await teacher.send('POST', '/teachers', { token, username: 'k.otto', password })
})

test('the password is changed, and a wrong or a common one is shown at its field', async () => {
  const own = new OwnAccount(teacher)
  expect(await own.changePassword('kastanie', 'kastanie im schnee')).toBe(false)
  expect(fieldOf(own.change.refused)).toBe('password')
  expect(await own.changePassword(password, 'basketball')).toBe(false)
  expect(fieldOf(own.change.refused)).toBe('newPassword')
  expect(await own.changePassword(password, 'kastanie im schnee')).toBe(true)
  expect([own.change.refused, own.isChanged]).toEqual([null, true])
  const tablet = new Account(apiOn(server))
  await expect(tablet.signIn('k.otto', password)).rejects.toMatchObject({ code: 'wrongPassword' })
  await tablet.signIn('k.otto', 'kastanie im schnee')
  expect(tablet.access.kind).toBe('in')
})

test('a teacher sees the classes that are in the way, also one that another page has just made', async () => {
  const own = new OwnAccount(teacher)
  await own.load(false)
  expect([own.classes, own.teachers]).toEqual([[], null])
  await teacher.send('POST', '/classes', newClass)
  expect(await own.deleteAccount(password)).toBe(false)
  expect(own.deletion.refused).toBe('ownsClasses')
  expect(own.classes).toMatchObject([{ name: '5b' }])
})

test('a teacher without classes deletes the account and is signed out', async () => {
  const own = new OwnAccount(teacher)
  expect(await own.deleteAccount('kastanie')).toBe(false)
  expect(fieldOf(own.deletion.refused)).toBe('password')
  expect(await own.deleteAccount(password)).toBe(true)
  const account = new Account(teacher)
  await account.look()
  expect(account.access.kind).toBe('out')
})

test('the operator deletes a teacher from the list, and is the only one who stays', async () => {
  await teacher.send('POST', '/classes', newClass)
  const own = new OwnAccount(operator)
  await own.load(true)
  expect(own.isOnlyOperator).toBe(true)
  expect(own.teachers).toMatchObject([
    { username: 'k.otto', operator: false, classes: 1, pupils: 0 },
    { username: 'm.weber', operator: true, classes: 0, pupils: 0 },
  ])
  expect(await own.deleteTeacher(own.teachers![0]!, 'k.weber')).toBe(false)
  expect(own.removal.refused).toBe('otherUsername')
  expect(await own.deleteTeacher(own.teachers![0]!, 'k.otto')).toBe(true)
  expect(own.teachers).toMatchObject([{ username: 'm.weber' }])
})

test.each(['noServer', 'ownsClasses', null])('a refusal such as %s belongs to no field', (code) => {
  expect(fieldOf(code)).toBeNull()
})
