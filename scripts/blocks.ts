// `npm run blocks`: writes the tables of the packs from the field `pack` of the blocks' definitions.
import { globSync, writeFileSync } from 'node:fs'
import { basename, join } from 'node:path'
import { format, resolveConfig } from 'prettier'
import type { Definition, Pack } from '@botgarten/blocks'
import { inHouse } from './prepare/house.mjs'

const folder = inHouse('packages/blocks')
const families =
  '{action,control,functions,lists,logic,math,messages,network,q-learning,sensors,sorting,text,variables}'
const note = '// Made by `npm run blocks`.\n'

interface Member {
  readonly type: string
  readonly file: string
  readonly pack: Pack
}

async function memberOf(file: string): Promise<Member> {
  const type = basename(file, '.ts')
  const module = (await import(join(folder, file))) as { readonly [name: string]: Definition }
  const definition = module[type]
  if (!definition) throw new Error(`${file} does not export ${type}.`)
  return { type, file, pack: definition.pack }
}

const tableOf = (pack: Pack, members: readonly Member[]) => `${note}
${members.map(({ type, file }) => `import { ${type} } from '../../${file}'`).join('\n')}
import type { TypeIn } from '../packs.ts'
import type { Definition } from '../../types.ts'

export const blocks: { readonly [T in TypeIn<'${pack}'>]: Definition } = { ${members.map(({ type }) => type).join(', ')} }
`

const packsOf = (members: readonly Member[]) => `${note}
import type { Pack } from '../types.ts'

/** Every block's pack, by its type: known before the pack is loaded. */
export const packs = { ${members.map(({ type, pack }) => `${type}: '${pack}'`).join(', ')} } as const satisfies { readonly [type: string]: Pack }

/** Every block's type, Open Roberta's own, so that programs travel. */
export type BlockType = keyof typeof packs

export type TypeIn<P extends Pack> = { [T in BlockType]: (typeof packs)[T] extends P ? T : never }[BlockType]
`

async function write(name: string, text: string): Promise<void> {
  const path = join(folder, 'packs', name)
  const options = await resolveConfig(path)
  writeFileSync(path, await format(text, { ...options, filepath: path }))
}

const files = globSync(`${families}/*.ts`, { cwd: folder })
const members = await Promise.all(
  files
    .map((file) => file.replaceAll('\\', '/'))
    .sort()
    .map(memberOf),
)
await write('packs.ts', packsOf(members))
for (const pack of ['core', 'learning', 'expert'] as const)
  await write(
    `${pack}/blocks.ts`,
    tableOf(
      pack,
      members.filter((member) => member.pack === pack),
    ),
  )
