import type { Db } from '../database/database.ts'

interface NamedAsset {
  readonly name: string
  readonly type: string
  readonly base64: string
}

/** Pictures as a project holds them. */
export const assetsIn = (rows: readonly NamedAsset[]) =>
  Object.fromEntries(rows.map(({ name, type, base64 }) => [name, { type, base64 }]))

/** The pictures of a version, as a project holds them. */
export async function assetsOf(db: Db, pupil: string, project: string, revision: number) {
  const rows = await db
    .selectFrom('versionAsset')
    .innerJoin('asset', (join) =>
      join.onRef('asset.class', '=', 'versionAsset.class').onRef('asset.hash', '=', 'versionAsset.hash'),
    )
    .select(['versionAsset.name', 'asset.type', 'asset.base64'])
    .where('pupil', '=', pupil)
    .where('project', '=', project)
    .where('revision', '=', revision)
    .execute()
  return assetsIn(rows)
}

const emptyAssets = '"assets":{}}'

/** As JSON. The parser has let the letters of base64 through alone, which need no escaping. */
const textOf = (assets: ReturnType<typeof assetsIn>) => {
  const all = Object.entries(assets).map(
    ([name, { type, base64 }]) =>
      `${JSON.stringify(name)}:{"type":${JSON.stringify(type)},"base64":"${base64}"}`,
  )
  return `{${all.join(',')}}`
}

/** The text of a stored document with its pictures in it. */
export const withAssets = (document: string, assets: ReturnType<typeof assetsIn>): string =>
  document.endsWith(emptyAssets)
    ? `${document.slice(0, -'{}}'.length)}${textOf(assets)}}`
    : JSON.stringify({ ...(JSON.parse(document) as object), assets })
