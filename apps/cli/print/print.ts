import { mkdirSync } from 'node:fs'
import { join } from 'node:path'
import type { BrowserContext, Page } from 'playwright-core'
import type { Command } from '../commands.ts'
import { causeOf, FileError } from '../errors.ts'
import { write } from '../files.ts'
import { openBrowser } from './browser.ts'
import { startServer } from './server.ts'
import type { Printable } from './items.ts'
import { known, orderOf, type Order } from './order.ts'
import { message, type Language } from '../words.ts'

interface Written {
  readonly file: string
  readonly bytes: number
}

/** A page that takes longer than this has gone wrong. */
const timeout = 60_000

/** `botgarten print ITEM…|all …`: materials as PDF, by the very pages that the lab prints. */
export const print: Command = { options: known, inLanguages: true, execute: printAll }

async function printAll(args: string[], asked: readonly Language[] = []): Promise<string> {
  const order = orderOf(args, asked)
  makeFolder(order.out)
  const written = await printed(order)
  if (order.json) return JSON.stringify(written)
  const lines = written.map(({ file, bytes }) => `${file}  ${Math.ceil(bytes / 1000)} kB`)
  return [
    ...lines,
    ...(order.paper === 'a4' && order.items.some(({ isCard }) => isCard)
      ? [message(`printed.turn-${order.turn}`)]
      : []),
  ].join('\n')
}

async function printed(order: Order): Promise<Written[]> {
  const server = await startServer()
  try {
    const browser = await openBrowser()
    try {
      const written: Written[] = []
      for (const language of order.languages) {
        const context = await browser.newContext({
          baseURL: server.url,
          // Dates as in Europe.
          locale: language === 'en' ? 'en-GB' : language,
          serviceWorkers: 'block',
        })
        written.push(...(await inLanguage(context, language, order)))
      }
      return written
    } finally {
      await browser.close()
    }
  } finally {
    server.close()
  }
}

async function inLanguage(context: BrowserContext, language: string, order: Order): Promise<Written[]> {
  const page = await context.newPage()
  const written: Written[] = []
  for (const found of order.items) {
    const pdf = await pdfOf(page, found, order)
    const file = join(order.out, nameOf(found, language, order.paper))
    write(file, pdf)
    written.push({ file, bytes: pdf.length })
  }
  return written
}

/** `card-04-q-railway-de-a5.pdf`, `sheet-01-q-program-de.pdf`: the same in every run. */
const nameOf = ({ file, isCard }: Printable, language: string, paper: string) =>
  `${file}-${language}${isCard ? `-${paper}` : ''}.pdf`

async function pdfOf(
  page: Page,
  { id, address: path }: Printable,
  { paper, turn, address, grey }: Order,
): Promise<Buffer> {
  const options = new URLSearchParams({ paper, turn, address: address ?? '', ...(grey && { grey: 'yes' }) })
  const errors: string[] = []
  const hear = (error: Error) => errors.push(error.message)
  page.on('pageerror', hear)
  try {
    await page.goto(`${path}${options.toString()}`)
    await page.locator('html[data-print=ready]').waitFor({ state: 'attached', timeout })
    return await page.pdf({ preferCSSPageSize: true, printBackground: true, tagged: true, outline: true })
  } catch (error) {
    const said = errors[0] ?? (error as Error).message
    throw new FileError('file.notPrinted', { id, message: said.split('\n')[0]! })
  } finally {
    page.off('pageerror', hear)
  }
}

function makeFolder(path: string): void {
  try {
    mkdirSync(path, { recursive: true })
  } catch (error) {
    throw new FileError('file.noFolder', { path, why: causeOf(error) })
  }
}
