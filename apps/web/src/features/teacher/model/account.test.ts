import { firstTeacherToken } from '@botgarten/classroom'
import type { Server } from '@botgarten/classroom/testing'
import { beforeEach, expect, test } from 'vitest'
import { apiOn, freshServer } from '../testing/class-server.ts'
import { Account } from './account.svelte.ts'
import { ClassApi } from './api.ts'

let server: Server
let api: ClassApi
let account: Account
beforeEach(async () => {
  server = await freshServer()
  api = apiOn(server)
  account = new Account(api)
})

const credentials = { username: 'm.weber', password: 'kastanie im regen' }
const makeFirst = async (from: ClassApi) =>
  from.send('POST', '/teachers', { token: (await firstTeacherToken(server.ports))!, ...credentials })

test('a server that waits for its first teacher is known as such', async () => {
  expect(account.access.kind).toBe('asking')
  await account.look()
  expect(account.access).toEqual({ kind: 'unmade' })
})

test('the one-time link makes an account and signs it in, once', async () => {
  const token = (await firstTeacherToken(server.ports))!
  await api.send('POST', '/teachers', { token, ...credentials })
  await account.look()
  expect(account.access).toEqual({ kind: 'in', username: 'm.weber', operator: true })
  const again = apiOn(server).send('POST', '/teachers', {
    token,
    username: 'other',
    password: 'ein langer satz',
  })
  await expect(again).rejects.toMatchObject({ code: 'linkUsedUp', status: 403 })
})

test('on another device the page tells when the first account was made, and takes the password', async () => {
  await makeFirst(apiOn(server))
  await account.look()
  expect(account.access).toEqual({ kind: 'out', madeAt: server.now })
  await expect(account.signIn('m.weber', 'something else')).rejects.toMatchObject({ code: 'wrongPassword' })
  await account.signIn(credentials.username, credentials.password)
  expect(account.access.kind).toBe('in')
  await account.signOut(false)
  expect(account.access.kind).toBe('out')
})

test('signing out on every device ends the others too', async () => {
  await makeFirst(api)
  const tablet = new Account(apiOn(server))
  await tablet.signIn(credentials.username, credentials.password)
  await account.look()
  await account.signOut(true)
  await tablet.look()
  expect(tablet.access.kind).toBe('out')
})

test.each([
  ['is not there', () => Promise.reject(new TypeError('Failed to fetch'))],
  ['serves files alone', () => Promise.resolve(new Response('<!doctype html>', { status: 404 }))],
  ['is none of ours', () => Promise.resolve(Response.json({ hello: 'world' }))],
])('where the server %s there is no class', async (_what, fetch) => {
  const lonely = new ClassApi(fetch)
  const nobody = new Account(lonely)
  await nobody.look()
  expect(nobody.access).toEqual({ kind: 'none' })
})
