import { fetchMaterials } from '#features/materials/library.ts'

export const load = () => fetchMaterials()
