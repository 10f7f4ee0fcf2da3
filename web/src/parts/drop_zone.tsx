import { useId, useState } from 'preact/hooks';

interface Props {
  label: string;
  hint: string;
  busy: string | null;
  /** Several are parts of one thing, such as .shp, .shx and .dbf. */
  take: (files: File[]) => void;
}

/** A place to drop a file, and a button that picks one. */
export function DropZone({ label, hint, busy, take }: Props) {
  const id = useId();
  const [over, setOver] = useState(false);
  const all = (files: FileList | null | undefined) => {
    if (files && files.length > 0) take([...files]);
  };
  return (
    <div
      class={`drop ${over ? 'over' : ''}`}
      onDragOver={(event) => {
        event.preventDefault();
        setOver(true);
      }}
      onDragLeave={() => setOver(false)}
      onDrop={(event) => {
        event.preventDefault();
        event.stopPropagation();
        setOver(false);
        all(event.dataTransfer?.files);
      }}
    >
      <input
        id={id} type="file" multiple class="unseen" disabled={busy !== null}
        onChange={(event) => {
          all(event.currentTarget.files);
          event.currentTarget.value = '';
        }}
      />
      <label for={id} class="button main">{label}</label>
      <p class="hint" role="status">{busy ?? hint}</p>
    </div>
  );
}
