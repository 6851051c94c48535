// A language is a folder of messages: one that is made up here is offered, spoken, and falls back where it has no words.
import { cpSync, mkdirSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { languagesIn, wordsFolder } from '@botgarten/messages/folder'
import { svelte } from '@sveltejs/vite-plugin-svelte'
import type { Component } from 'svelte'
import { createServer } from 'vite'
import { expect, onTestFinished, test, vi } from 'vitest'
import { wordsFrom } from '../../words.ts'

/** The page's modules over another folder of words. */
async function pageWith(folder: string) {
  const server = await createServer({
    configFile: false,
    root: join(import.meta.dirname, '../..'),
    plugins: [wordsFrom(folder), svelte()],
    server: { middlewareMode: true, hmr: false, ws: false, watch: null },
    optimizeDeps: { noDiscovery: true },
    appType: 'custom',
    logLevel: 'error',
  })
  onTestFinished(() => server.close())
  const load = async <Module>(file: string) => (await server.ssrLoadModule(file)) as Module
  const { language } = await load<typeof import('./language.svelte.ts')>('/src/words/language.svelte.ts')
  const { fetchWords, message } = await load<typeof import('./message.ts')>('/src/words/message.ts')
  const { render } = await load<typeof import('svelte/server')>('svelte/server')
  const offers = await load<{ default: Component }>('/src/parts/LanguageSwitch.svelte')
  return { language, fetchWords, message, html: () => render(offers.default).body }
}

test('a folder of messages is a language: offered, spoken, and filled where it has no words', async () => {
  const folder = mkdtempSync(join(tmpdir(), 'words-'))
  onTestFinished(() => rmSync(folder, { recursive: true }))
  cpSync(wordsFolder, folder, { recursive: true })
  mkdirSync(join(folder, 'xx'))
  writeFileSync(join(folder, 'xx', 'app.json'), JSON.stringify({ world: { lost: 'Bo xix xax.' } }))
  const told = vi.spyOn(console, 'error')

  const { language, fetchWords, message, html } = await pageWith(folder)
  expect(language.all).toEqual([...languagesIn(), 'xx'])
  await fetchWords('app', 'projects')
  expect(html()).toMatch(/<button[^>]* lang="xx"[^>]*>XX<\/button>/)

  await language.speak('xx' as 'en')
  expect(language.locale).toBe('xx')
  expect(message('world.lost')).toBe('Bo xix xax.')
  expect(message('home.title')).toBe('Teach a robot.')
  expect([1, 2].map((days) => message('projects.days', { days }))).toEqual(['Last day', '2 days left'])
  expect(told).not.toHaveBeenCalled()
})
