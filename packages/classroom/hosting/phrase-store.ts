import { createCipheriv, createDecipheriv, createHmac, randomBytes } from 'node:crypto'
import { codeWords, type CodeLanguage } from '@botgarten/content/codes'
import type { Database, Db } from '../database/database.ts'

/** Words of a passphrase. A list has at least 512, which gives 90 bits: out of reach for guessing. */
const words = 10

const row = { phrase: 'backup phrase', shown: 'backup phrase shown' } as const

/** The database holds the phrase sealed by the server's key, so that the file alone does not open its own backups. */
const sealKey = (secret: Uint8Array) =>
  createHmac('sha256', secret).update('seal of the backup phrase').digest()

const [nonceLength, tagLength] = [12, 16]

function seal(secret: Uint8Array, text: string): string {
  const nonce = randomBytes(nonceLength)
  const cipher = createCipheriv('aes-256-gcm', sealKey(secret), nonce, { authTagLength: tagLength })
  const sealed = Buffer.concat([cipher.update(text, 'utf8'), cipher.final()])
  return Buffer.concat([nonce, sealed, cipher.getAuthTag()]).toString('base64url')
}

/** @throws where another key has sealed it */
function unseal(secret: Uint8Array, text: string): string {
  const bytes = Buffer.from(text, 'base64url')
  const nonce = bytes.subarray(0, nonceLength)
  const cipher = createDecipheriv('aes-256-gcm', sealKey(secret), nonce, { authTagLength: tagLength })
  cipher.setAuthTag(bytes.subarray(-tagLength))
  return cipher.update(bytes.subarray(nonceLength, -tagLength), undefined, 'utf8') + cipher.final('utf8')
}

/** A new passphrase: `apple-river-…`, lower-case words of the language's list with hyphens, as `age` wants it typed. */
function newPhrase(language: CodeLanguage): string {
  const list = codeWords(language)
  // The length of the list is a power of two and divides 65,536: all words are equally likely.
  return Array.from({ length: words }, () => list[randomBytes(2).readUInt16BE() % list.length]!).join('-')
}

/** The passphrase as people type it: in capitals, with spaces or hyphens, over several lines. */
export const phraseFrom = (typed: string): string =>
  typed
    .normalize('NFKC')
    .toLowerCase()
    .split(/[^a-z]+/)
    .filter((word) => word !== '')
    .join('-')

const readMeta = async (db: Db, key: string): Promise<string | undefined> =>
  (await db.selectFrom('meta').select('value').where('key', '=', key).executeTakeFirst())?.value

const addMeta = (db: Db, key: string, value: string) =>
  db
    .insertInto('meta')
    .values({ key, value })
    .onConflict((conflict) => conflict.column('key').doNothing())
    .execute()

/** The language of the first class; English before there is one. */
async function languageOf(db: Db): Promise<CodeLanguage> {
  const found = await db.selectFrom('class').select('language').orderBy('madeAt').executeTakeFirst()
  return found?.language === 'de' ? 'de' : 'en'
}

/** The passphrase of all backups of this server: made once, the same from then on. */
export async function phraseOf({ db }: Pick<Database, 'db'>, secret: Uint8Array): Promise<string> {
  const found = await readMeta(db, row.phrase)
  if (found !== undefined) return unseal(secret, found)
  await addMeta(db, row.phrase, seal(secret, newPhrase(await languageOf(db))))
  return unseal(secret, (await readMeta(db, row.phrase))!)
}

/** Has the operator seen the passphrase? Until then it is shown without the password. */
export const phraseShown = async (db: Db): Promise<boolean> => (await readMeta(db, row.shown)) !== undefined

export const markPhraseShown = async (db: Db): Promise<void> => void (await addMeta(db, row.shown, '1'))
