import { mkdtempSync, readFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { startServer } from '../../packages/server/index.ts'
import { expect, follows, link, test, title } from './gate.ts'

test.use({
  language: 'en',
  complaints: [/status of 404|^A request to http:\/\/(guest\.)?localhost:\d+\//],
})

const web = new URL('../../apps/web/package.json', import.meta.url)

test(
  'the page about Botgarten names its version, its libraries and whole licences',
  {
    tag: ['@about', '@/about'],
  },
  async ({ child, page }) => {
    await follows(child, 'parts.about')
    await expect(title(page)).toHaveText(child.word('about.title'))
    const { version } = JSON.parse(readFileSync(web, 'utf8')) as { version: string }
    await expect(child.words('about.version', { version })).toBeVisible()
    await expect(page.getByRole('row').filter({ hasText: 'blockly' })).toContainText('Apache')
    await expect(link(child, 'about.teachers')).toHaveAttribute('href', '/teacher')
    await page.getByRole('link', { name: 'Apache License 2.0' }).click()
    await expect(page.locator('body')).toContainText('TERMS AND CONDITIONS')
  },
)

test('an unknown address shows a message and leads home', { tag: '@/+error' }, async ({ child, page }) => {
  await page.goto('/lab/nosuchcard')
  await expect(title(page)).toHaveText(child.word('lab.unknownCardTitle'))
  await page.goto('/no/such/page')
  await expect(title(page)).toHaveText(child.word('parts.lostTitle'))
  await link(child, 'parts.toHome').click()
  await expect(title(page)).toContainText(child.word('home.title'))
})

test(
  'the machine that serves leads to a class or to the lab, and shows a guest nothing of itself',
  {
    tag: ['@here', '@/here'],
  },
  async ({ child, page, house }) => {
    await page.goto('/here#a-link-of-the-first-teacher')
    await expect(title(page)).toHaveText(child.word('here.title'))
    await expect(page.getByText(child.word('here.kept'))).toContainText('botgarten-data-')
    await page.getByRole('link', { name: child.word('here.class') }).click()
    await expect(page).toHaveURL(/\/teacher\/start#a-link-of-the-first-teacher$/)
    await page.goBack()
    await page.getByRole('link', { name: child.word('here.alone') }).click()
    await expect(title(page)).toContainText(child.word('home.title'))
    await page.goto(`http://guest.localhost:${new URL(house).port}/here`)
    await expect(title(page)).toHaveText(child.word('here.elsewhere'))
    await expect(page.getByText(child.word('here.kept'))).toHaveCount(0)
    await expect(page.getByRole('link', { name: child.word('here.join') })).toHaveAttribute('href', '/join')
  },
)

test(
  'a device is led to trust a server that answers https, and is told of one that does not',
  {
    tag: ['@trust', '@/trust'],
  },
  async ({ child, page, request }) => {
    await page.goto('/trust')
    await expect(title(page)).toHaveText(child.word('trust.none'))
    const https = mkdtempSync(join(tmpdir(), 'botgarten-gate-'))
    const server = await startServer({ port: 0, host: '127.0.0.1', https })
    await page.goto(`${server.url}/trust`)
    await expect(title(page)).toHaveText(child.word('trust.title'))
    const place = `https://${new URL(server.url).hostname}:${server.securePort}`
    await expect(page.getByRole('link', { name: place })).toHaveAttribute('href', place)
    await expect(page.getByRole('img', { name: child.word('trust.code') })).toBeVisible()
    const certificate = await link(child, 'trust.fetchButton').getAttribute('href')
    expect(await (await request.get(`${server.url}${certificate}`)).text()).toContain('BEGIN CERTIFICATE')
    await server.close()
  },
)
