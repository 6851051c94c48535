import { mkdirSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { afterEach, beforeEach, expect, test } from 'vitest'
import { baseline, readPolicies, transportOf } from './policies.ts'

let folder = ''
beforeEach(() => (folder = mkdtempSync(join(tmpdir(), 'botgarten-policies-'))))
afterEach(() => rmSync(folder, { recursive: true }))

const page = (policy: string) =>
  `<head><meta http-equiv="content-security-policy" content="${policy}"></head>`

test('a prerendered page is sent with the policy of its meta, and what a meta cannot say', () => {
  mkdirSync(join(folder, 'lab'))
  writeFileSync(join(folder, 'index.html'), page("script-src 'self' 'sha256-a='"))
  writeFileSync(join(folder, 'lab', 'fear.html'), page("script-src 'self' 'sha256-b='"))
  writeFileSync(join(folder, 'lab', 'index.html'), page("script-src 'self'"))
  expect(Object.fromEntries(readPolicies(folder))).toEqual({
    '/': "script-src 'self' 'sha256-a='; form-action 'self'; frame-ancestors 'self'",
    '/lab/fear': "script-src 'self' 'sha256-b='; form-action 'self'; frame-ancestors 'self'",
    '/lab': "script-src 'self'; form-action 'self'; frame-ancestors 'self'",
  })
})

test('a page without a policy gets the common one', () => {
  writeFileSync(join(folder, 'bare.html'), '<p>bare</p>')
  expect(readPolicies(folder).get('/bare')).toBe(baseline)
})

test.each([
  ['https://lab.example.org', 'https', 'max-age=15552000'],
  ['https://lab.example.org', 'http', null],
  ['http://lab.example.org', 'https', null],
  [null, 'https', null],
])('announced as %s, a request over %s gets Strict-Transport-Security %s', (origin, forwarded, header) =>
  expect(transportOf(origin, forwarded)).toBe(header),
)
